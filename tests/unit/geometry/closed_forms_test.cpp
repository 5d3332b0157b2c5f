// SPDX-License-Identifier: Apache-2.0
// What proves the whole: the brute force of the publication on 200 random models, closed forms in up to 256 parts
// against their formulas, other orders of triangles and objects, moved positions.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

using Place = std::tuple<double, double, double>;
Place place(dvec3 p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

dvec3 world_position(const Shape& s, std::uint32_t v) {
    return transform_point(s.to_world, cast<double>(s.positions[v]));
}
dvec3 outward(const Shape& s, dvec3 n) {
    const dmat3 m = upper_left(s.to_world);
    return normalize_or(cofactor(m) * n * (determinant(m) < 0 ? -1.0 : 1.0), dvec3{});
}

// The published sum at every place: each face of each object adds its unit normal at each place where it has a corner,
// once. The same sums as comparing every vertex with every face (smooth_normals_test.cpp does that), listed by place.
std::map<Place, dvec3> published_sums(const std::vector<Shape>& shapes) {
    std::map<Place, dvec3> sums;
    for (const Shape& s : shapes)
        for (std::size_t t = 0; t < s.indices.size() / 3; ++t) {
            const dvec3 product = edge_product(s, t);
            if (product == dvec3{}) continue;
            const dvec3 n = outward(s, product);
            std::vector<Place> corners;
            for (std::size_t k = 0; k < 3; ++k) corners.push_back(place(world_position(s, s.indices[3 * t + k])));
            std::sort(corners.begin(), corners.end());
            corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
            for (const Place& c : corners) sums[c] += n;
        }
    return sums;
}

// Up to 5000 triangles in up to 8 objects over a lattice; one matrix for all, or quarter turns and shifts, exact in
// binary.
std::vector<Shape> random_model(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<Shape> shapes(1 + random() % 8);
    const dmat4 common = random_affine(random, seed % 2 == 0);
    const std::uint32_t size = 1 + random() % 625, side = 3 + random() % 12;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        Shape& s = shapes[i];
        s.object = std::uint32_t(i);
        s.to_world = seed % 3 == 0 ? common
                                   : translation(dvec3{double(random() % 3), 0, -2}) *
                                         scaling(dvec3{i % 2 == 0 ? 1.0 : -1.0, 1, 2});
        for (std::uint32_t v = 0; v < size; ++v)
            s.positions.push_back(
                {float(int(random() % side)) - 2, float(int(random() % side)), 0.5f * float(int(random() % side))});
        for (std::uint32_t t = 0; t < 3 * size; ++t) s.indices.push_back(random() % size);
    }
    return shapes;
}

TEST(Oracle, TwoHundredRandomModelsOfUpToFiveThousandTrianglesAgreeTo1e5) {
    std::size_t compared = 0, largest = 0;
    double worst = 0;
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        const auto shapes = random_model(seed);
        const auto sums = published_sums(shapes);
        const auto out = compute(shapes, published());
        std::size_t triangles = 0;
        for (std::size_t m = 0; m < shapes.size(); ++m) {
            triangles += shapes[m].indices.size() / 3;
            for (std::size_t i = 0; i < shapes[m].indices.size(); ++i) {
                const auto sum = sums.find(place(world_position(shapes[m], shapes[m].indices[i])));
                if (sum == sums.end() || length(sum->second) < 1e-2) continue;  // cancelled: tests of their own
                const dvec3 got = outward(shapes[m], cast<double>(corner_normal(shapes[m], out[m], i)));
                worst = std::max(worst, length(got - normalize_or(sum->second, dvec3{})));
                ++compared;
            }
        }
        largest = std::max(largest, triangles);
    }
    EXPECT_LT(worst, 1e-5);
    EXPECT_GT(compared, 100000u);
    EXPECT_GT(largest, 4000u);
    EXPECT_LE(largest, 5000u);
}

struct Form {
    const char* name;
    Shape whole;
    dvec3 (*normal)(dvec3);
};

std::vector<Form> forms() {
    return {{"sphere", make_sphere(64, 32), [](dvec3 p) { return normalize_or(p, dvec3{}); }},
            {"torus", make_torus(64, 32),
             [](dvec3 p) {
                 const dvec3 ring = normalize_or(dvec3{p.x, 0, p.z}, dvec3{}) * 2.0;
                 return normalize_or(p - ring, dvec3{});
             }},
            {"cylinder", make_cylinder(64, 16), [](dvec3 p) {
                 return normalize_or(dvec3{p.x, 0, p.z}, dvec3{});
             }}};
}

// The largest angle between a part's normals and the formula; all normals at a place must be the same bits.
double worst_error(const Form& form, const std::vector<Shape>& parts, const AttributeOptions& options) {
    const auto out = compute(parts, options);
    std::map<Place, vec3> seen;
    double worst = 0;
    std::size_t seams = 0;
    for (std::size_t m = 0; m < parts.size(); ++m)
        for (std::size_t i = 0; i < parts[m].indices.size(); ++i) {
            const dvec3 p = cast<double>(parts[m].positions[parts[m].indices[i]]);
            const vec3 n = corner_normal(parts[m], out[m], i);
            const auto [at, is_new] = seen.try_emplace(place(p), n);
            seams += !is_new && !(at->second == n);
            worst = std::max(worst, angle_between(cast<double>(n), form.normal(p)));
        }
    EXPECT_EQ(seams, 0u) << form.name << " in " << parts.size();
    return worst;
}

TEST(ClosedForms, PartsHaveNoSeamAndNoLargerErrorThanTheWhole) {
    for (const CornerWeight weight :
         {CornerWeight::uniform, CornerWeight::area, CornerWeight::angle, CornerWeight::angle_area, CornerWeight::max})
        for (const double deg : {60.0, 180.0})
            for (const Form& form : forms()) {
                AttributeOptions options;
                options.weight = weight;
                options.crease_angle_rad = radians(deg);
                const double uncut = worst_error(form, {form.whole}, options);
                EXPECT_LT(degrees(uncut), 7) << form.name;
                for (const std::uint32_t parts : {2u, 16u, 256u}) {
                    EXPECT_LE(worst_error(form, cut_by_planes(form.whole, parts), options), uncut + 1e-6)
                        << form.name << parts;
                    EXPECT_LE(worst_error(form, cut_at_random(form.whole, parts, parts), options), uncut + 1e-6)
                        << form.name << parts;
                }
            }
}

/// Its vertices are moved about on it: triangles of all shapes.
Shape uneven_sphere() {
    Shape s = make_sphere(24, 12);
    std::map<Place, vec3> moved;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> shift(-0.05, 0.05);
    for (vec3& p : s.positions) {
        const double far_from_pole = 1 - std::fabs(double(p.y));
        const dvec3 away = dvec3{shift(random), shift(random), shift(random)} * far_from_pole;
        const auto at =
            moved.try_emplace(place(cast<double>(p)), cast<float>(normalize_or(cast<double>(p) + away, {})));
        p = at.first->second;
    }
    return s;
}

TEST(ClosedForms, TheWeightOfMaxIsExactOnASphere) {
    AttributeOptions options;
    options.crease_angle_rad = pi;
    const auto worst = [&](const Shape& s) {
        const Form form{"sphere", s, [](dvec3 p) { return normalize_or(p, {}); }};
        return degrees(worst_error(form, {s}, options));
    };
    Shape sphere = uneven_sphere();
    EXPECT_GT(worst(sphere), 1) << "by angle";
    options.weight = CornerWeight::max;
    EXPECT_LT(worst(sphere), 1e-3);
    for (const float size : {1e-18f, 1e15f}) {
        Shape other = sphere;
        for (vec3& p : other.positions) p = p * size;
        EXPECT_LT(worst(other), 1e-3) << size;
    }
}

TEST(ClosedForms, PermutedTrianglesAndObjectsGiveTheSameWithin1e5) {
    for (const TangentMode mode : {TangentMode::averaged, TangentMode::published}) {
        AttributeOptions options;
        options.tangent_mode = mode;
        const auto parts = cut_by_planes(make_torus(32, 16), 4);
        const auto before = compute(parts, options);
        std::mt19937 random(8);
        std::vector<std::size_t> order(parts.size());
        std::iota(order.begin(), order.end(), 0u);
        std::shuffle(order.begin(), order.end(), random);
        std::vector<Shape> shuffled;
        for (const std::size_t m : order) {
            Shape s = parts[m];
            std::vector<std::size_t> triangles(s.indices.size() / 3);
            std::iota(triangles.begin(), triangles.end(), 0u);
            std::shuffle(triangles.begin(), triangles.end(), random);
            for (std::size_t t = 0; t < triangles.size(); ++t)
                for (std::size_t k = 0; k < 3; ++k) s.indices[3 * t + k] = parts[m].indices[3 * triangles[t] + k];
            shuffled.push_back(s);
        }
        const auto after = compute(shuffled, options);
        for (std::size_t i = 0; i < order.size(); ++i) {
            const MeshAttributes &a = before[order[i]], &b = after[i];
            ASSERT_EQ(a.normals.size(), b.normals.size());
            for (std::size_t v = 0; v < a.normals.size(); ++v) {
                EXPECT_LT(length(a.normals[v] - b.normals[v]), 1e-5f);
                EXPECT_LT(length(a.tangents[v].xyz() - b.tangents[v].xyz()), 1e-5f);
                EXPECT_EQ(a.tangents[v].w, b.tangents[v].w);
            }
        }
    }
}

TEST(ClosedForms, AccumulateAfterMovingPositionsEqualsAFreshRun) {
    for (const TangentMode mode : {TangentMode::averaged, TangentMode::published, TangentMode::mikktspace})
        for (const int threads : {1, 2, 4}) {
            AttributeOptions options;
            options.tangent_mode = mode;
            options.crease_angle_rad = radians(120);
            auto parts = cut_at_random(make_torus(48, 24), 5, 3);
            Context context({.threads = threads});
            const AttributePlan plan = group(views(parts), options, context);
            for (Shape& s : parts)
                for (vec3& p : s.positions) p = {p.x * 1.5f + 0.1f * p.y, p.y - 0.2f * p.z, p.z + 0.25f * p.x};
            const auto moved = accumulate(plan, views(parts), context), fresh = compute(parts, options, 1);
            EXPECT_LE(largest_difference(moved, fresh), float_rounding);
        }
}

}  // namespace
}  // namespace rakelight::test
