// SPDX-License-Identifier: Apache-2.0
// Normals over whole models: the published brute force as the oracle, closed forms, cuts into parts, threads, permutations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>

#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

bool outward_flips(const dmat4& m) { return determinant(upper_left(m)) < 0; }

// Every vertex of every object against every face of every object: the sum of unit face normals over all faces that have a
// corner at an equal world position. In the world; a face with two corners there counts once. Zero area is judged before the
// matrix, whose rounding gives collinear corners an area of noise.
std::vector<std::vector<dvec3>> brute_force(const std::vector<Shape>& shapes, bool within_objects = false) {
    std::vector<std::vector<dvec3>> sums;
    for (const Shape& s : shapes) {
        sums.emplace_back(s.positions.size());
        for (std::size_t v = 0; v < s.positions.size(); ++v) {
            const dvec3 p = transform_point(s.to_world, cast<double>(s.positions[v]));
            for (const Shape& other : shapes) {
                if (within_objects && other.object != s.object) continue;
                for (std::size_t t = 0; t < other.indices.size(); t += 3) {
                    if (edge_product(other, t / 3) == dvec3{}) continue;
                    dvec3 q[3];
                    for (std::size_t k = 0; k < 3; ++k)
                        q[k] = transform_point(other.to_world, cast<double>(other.positions[other.indices[t + k]]));
                    if (p != q[0] && p != q[1] && p != q[2]) continue;
                    const dvec3 n = normalize_or(cross(q[1] - q[0], q[2] - q[0]), dvec3{});
                    sums.back()[v] += outward_flips(other.to_world) ? -n : n;
                }
            }
        }
    }
    return sums;
}

// An object's normal in the world.
dvec3 world_normal(const Shape& s, vec3 n) {
    const dvec3 w = cofactor(upper_left(s.to_world)) * cast<double>(n);
    return normalize_or(outward_flips(s.to_world) ? -w : w, dvec3{});
}

// Objects of random triangles over a small lattice, so that many corners coincide; some share a random matrix.
std::vector<Shape> random_model(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<Shape> shapes(1 + random() % 5);
    const dmat4 common = random_affine(random, random() % 2 == 0);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        Shape& s = shapes[i];
        s.object = std::uint32_t(i / 2);
        s.to_world = seed % 3 == 0 ? dmat4{} : common;
        if (seed % 5 == 0 && i == 1) s.to_world = scaling(dvec3{-1, 1, 1});
        const std::uint32_t vertices = 4 + random() % 60, triangles = 1 + random() % 80;
        for (std::uint32_t v = 0; v < vertices; ++v)
            s.positions.push_back(
                {float(int(random() % 5) - 2), float(int(random() % 5) - 2), float(int(random() % 5) - 2)});
        for (std::uint32_t t = 0; t < 3 * triangles; ++t) s.indices.push_back(random() % vertices);
    }
    return shapes;
}

void expect_oracle(const std::vector<Shape>& shapes, const AttributeOptions& options, std::uint32_t seed) {
    const auto truth = brute_force(shapes, options.scope == Scope::object);
    const auto result = compute(shapes, options);
    std::size_t compared = 0;
    for (std::size_t m = 0; m < shapes.size(); ++m)
        for (std::size_t i = 0; i < shapes[m].indices.size(); ++i) {
            const std::uint32_t v = shapes[m].indices[i];
            if (length(truth[m][v]) < 1e-3) continue;  // cancelled or without a face: other tests
            const dvec3 expected = normalize_or(truth[m][v], dvec3{});
            const dvec3 got = world_normal(shapes[m], corner_normal(shapes[m], result[m], i));
            EXPECT_LT(length(expected - got), 1e-5) << "seed " << seed << " mesh " << m << " vertex " << v;
            ++compared;
        }
    EXPECT_GT(compared, 0u) << "seed " << seed;
}

bool same_bits(const std::vector<MeshAttributes>& a, const std::vector<MeshAttributes>& b) {
    if (a.size() != b.size()) return false;
    const auto equal = [](const auto& x, const auto& y) {
        return x.size() == y.size() && (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0);
    };
    for (std::size_t m = 0; m < a.size(); ++m) {
        if (a[m].indices != b[m].indices || a[m].source_vertex != b[m].source_vertex) return false;
        if (!equal(a[m].normals, b[m].normals) || !equal(a[m].tangents, b[m].tangents)) return false;
    }
    return true;
}

TEST(SmoothNormals, EqualTheBruteForceOverEveryFaceOfEveryObject) {
    for (std::uint32_t seed = 1; seed <= 80; ++seed) expect_oracle(random_model(seed), published(), seed);
}

TEST(SmoothNormals, EqualTheBruteForceInsideEachObject) {
    AttributeOptions options = published();
    options.scope = Scope::object;
    for (std::uint32_t seed = 1; seed <= 80; ++seed) expect_oracle(random_model(seed), options, seed);
}

// The general way with corners in bins must give the same as the fast one: at 179.99 degrees only opposite faces part.
TEST(SmoothNormals, GeneralAndFastWayAgreeOnClosedSurfaces) {
    for (const Shape& whole : {make_sphere(24, 12), make_torus(24, 12)}) {
        const auto parts = cut_at_random(whole, 4, 7);
        AttributeOptions general = published();
        general.crease_angle_rad = radians(179.99);
        const auto a = compute(parts, published()), b = compute(parts, general);
        for (std::size_t m = 0; m < parts.size(); ++m) {
            EXPECT_TRUE(b[m].indices.empty());
            ASSERT_EQ(a[m].normals.size(), b[m].normals.size());
            for (std::size_t v = 0; v < a[m].normals.size(); ++v)
                EXPECT_LT(length(cast<double>(a[m].normals[v]) - cast<double>(b[m].normals[v])), 1e-6);
        }
    }
}

void expect_parts_equal_whole(const Shape& whole, const std::vector<Shape>& parts, const AttributeOptions& options) {
    const auto key = [](vec3 p) { return std::tuple(p.x + 0.0f, p.y + 0.0f, p.z + 0.0f); };
    const MeshAttributes reference = compute({whole}, options).front();
    ASSERT_TRUE(reference.indices.empty());
    std::map<std::tuple<float, float, float>, vec3> uncut, seen;
    for (std::size_t v = 0; v < whole.positions.size(); ++v) uncut[key(whole.positions[v])] = reference.normals[v];
    const auto result = compute(parts, options);
    for (std::size_t m = 0; m < parts.size(); ++m)
        for (std::size_t v = 0; v < parts[m].positions.size(); ++v) {
            const vec3 n = result[m].normals[v];
            const auto at = key(parts[m].positions[v]);
            EXPECT_LT(angle_between(n, uncut.at(at)), 1e-6);
            const auto [before, is_new] = seen.try_emplace(at, n);
            EXPECT_TRUE(is_new || before->second == n) << "part " << m << " vertex " << v;  // bit-equal across parts
        }
}

TEST(SmoothNormals, PartsOfClosedFormsEqualTheWholeAndOneAnotherToTheBit) {
    for (const Shape& whole : {make_sphere(40, 20), make_cylinder(40, 7), make_torus(40, 20)})
        for (const CornerWeight weight : {CornerWeight::uniform, CornerWeight::area, CornerWeight::angle,
                                          CornerWeight::angle_area, CornerWeight::max})
            for (const double crease : {pi, radians(60)}) {
                AttributeOptions options = published();
                options.weight = weight;
                options.crease_angle_rad = crease;
                options.tangents = false;
                for (const std::uint32_t parts : {2u, 16u}) {
                    expect_parts_equal_whole(whole, cut_by_planes(whole, parts), options);
                    expect_parts_equal_whole(whole, cut_at_random(whole, parts, parts), options);
                }
            }
}

TEST(SmoothNormals, AngleWeightComesNearTheTrueNormals) {
    AttributeOptions options = published();
    options.weight = CornerWeight::angle;
    const Shape sphere = make_sphere(96, 48), cylinder = make_cylinder(96, 6), torus = make_torus(192, 64);
    const auto worst = [&](const Shape& s, const auto& truth) {
        const MeshAttributes out = compute({s}, options).front();
        double angle = 0;
        for (std::size_t v = 0; v < s.positions.size(); ++v)
            angle = std::fmax(angle, angle_between(cast<double>(out.normals[v]), truth(cast<double>(s.positions[v]))));
        return degrees(angle);
    };
    EXPECT_LT(worst(sphere, [](dvec3 p) { return normalize_or(p, dvec3{}); }), 0.2);
    EXPECT_LT(worst(cylinder, [](dvec3 p) { return dvec3{p.x, 0, p.z}; }), 0.01);
    EXPECT_LT(worst(torus,
                    [](dvec3 p) {
                        const dvec3 center = normalize_or(dvec3{p.x, 0, p.z}, dvec3{}) * 2.0;
                        return normalize_or(p - center, dvec3{});
                    }),
              0.2);
}

TEST(SmoothNormals, ScopesDifferAsTheirNamesSay) {
    const auto parts = cut_by_planes(make_sphere(24, 12), 2);
    AttributeOptions options = published();
    const auto model = compute(parts, options);
    options.scope = Scope::object;
    const auto object = compute(parts, options);
    options.scope = Scope::face;
    const auto face = compute(parts, options);
    const auto seam = [&](const std::vector<MeshAttributes>& result) {
        double worst = 0;
        for (std::size_t a = 0; a < parts[0].positions.size(); ++a)
            for (std::size_t b = 0; b < parts[1].positions.size(); ++b)
                if (parts[0].positions[a] == parts[1].positions[b])
                    worst = std::fmax(worst, degrees(angle_between(result[0].normals[a], result[1].normals[b])));
        return worst;
    };
    EXPECT_EQ(seam(model), 0);
    EXPECT_GT(seam(object), 5);
    for (std::size_t t = 0; t < parts[0].indices.size() / 3; ++t) {  // flat: three equal corners, the face's own normal
        if (edge_product(parts[0], t) == dvec3{}) continue;          // at the poles
        const vec3 a = corner_normal(parts[0], face[0], 3 * t), b = corner_normal(parts[0], face[0], 3 * t + 1);
        EXPECT_EQ(a, b);
        EXPECT_EQ(a, cast<float>(normalize_or(edge_product(parts[0], t), dvec3{})));
        EXPECT_EQ(a, corner_normal(parts[0], face[0], 3 * t + 2));
    }
    EXPECT_EQ(face[0].normals.size(), parts[0].positions.size() + face[0].source_vertex.size());
}

TEST(SmoothNormals, MeshesOfOneObjectAreSmoothedTogetherInScopeObject) {
    auto parts = cut_by_planes(make_sphere(24, 12), 2);
    parts[1].object = parts[0].object;
    AttributeOptions options = published();
    const auto model = compute(parts, options);
    options.scope = Scope::object;
    EXPECT_TRUE(same_bits(model, compute(parts, options)));
}

TEST(SmoothNormals, BitsDoNotDependOnThreads) {
    // Large enough for several pieces a mesh, with a shuffled order so that pieces hand votes to one another.
    Shape whole = make_sphere(500, 260);
    std::mt19937 random(3);
    for (vec3& p : whole.positions) {
        const float height = 1 + 0.01f * std::sin(20 * p.x) * std::cos(17 * p.y);
        p = p * height;
    }
    std::vector<std::uint32_t> order(whole.indices.size() / 3);
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    Shape shuffled = whole;
    for (std::size_t t = 0; t < order.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) shuffled.indices[3 * t + k] = whole.indices[3 * order[t] + k];
    for (const double crease : {pi, radians(60), radians(2)}) {
        AttributeOptions options = published();
        options.crease_angle_rad = crease;
        const auto one = compute({shuffled}, options, 1);
        EXPECT_TRUE(same_bits(one, compute({shuffled}, options, 2))) << crease;
        EXPECT_TRUE(same_bits(one, compute({shuffled}, options, 4))) << crease;
        if (crease > 1) {  // and the order of the triangles changes only roundings
            const auto ordered = compute({whole}, options, 2);
            ASSERT_EQ(ordered[0].normals.size(), one[0].normals.size());
            for (std::size_t v = 0; v < one[0].normals.size(); ++v)
                ASSERT_LT(length(cast<double>(one[0].normals[v]) - cast<double>(ordered[0].normals[v])), 1e-5);
        } else {
            EXPECT_GT(one[0].source_vertex.size(), 1000u);
        }
    }
}

TEST(SmoothNormals, PermutedObjectsGiveTheSameWithin1e5) {
    auto parts = cut_at_random(make_torus(30, 16), 5, 11);
    const auto before = compute(parts, published());
    std::reverse(parts.begin(), parts.end());
    auto after = compute(parts, published());
    std::reverse(after.begin(), after.end());
    for (std::size_t m = 0; m < before.size(); ++m)
        for (std::size_t v = 0; v < before[m].normals.size(); ++v)
            EXPECT_LT(length(cast<double>(before[m].normals[v]) - cast<double>(after[m].normals[v])), 1e-5);
}

TEST(SmoothNormals, MirroredAndScaledObjectsGetNormalsOfTheirOwnSpace) {
    std::mt19937 random(5);
    const Shape sphere = make_sphere(24, 12);
    for (const bool mirrored : {false, true}) {
        // Cut in two; one part is stored in coordinates that its matrix takes back: x mirrored, y doubled (exact in binary).
        auto parts = cut_by_planes(sphere, 2);
        const auto plain = compute(parts, published());
        for (vec3& p : parts[1].positions) p = {mirrored ? -p.x : p.x, p.y * 2, p.z};
        parts[1].to_world = scaling(dvec3{mirrored ? -1.0 : 1.0, 0.5, 1});
        if (mirrored)
            for (std::size_t i = 0; i < parts[1].indices.size(); i += 3)
                std::swap(parts[1].indices[i], parts[1].indices[i + 1]);
        const auto result = compute(parts, published());
        for (std::size_t v = 0; v < parts[0].positions.size(); ++v)
            EXPECT_LT(angle_between(result[0].normals[v], plain[0].normals[v]), 1e-6);
        for (std::size_t v = 0; v < parts[1].positions.size(); ++v)
            EXPECT_LT(angle_between(world_normal(parts[1], result[1].normals[v]), cast<double>(plain[1].normals[v])),
                      1e-6);
        EXPECT_EQ(result[1].source_vertex.size(), plain[1].source_vertex.size());
    }
}

TEST(SmoothNormals, ModelAThousandKilometersAwayLooksLikeOneAtTheOrigin) {
    auto parts = cut_by_planes(make_torus(24, 12), 4);
    const auto near = compute(parts, published());
    for (Shape& p : parts) p.to_world = translation(dvec3{1e6, -1e6, 3e5});
    EXPECT_TRUE(same_bits(near, compute(parts, published())));
}

}  // namespace
}  // namespace rakelight::test
