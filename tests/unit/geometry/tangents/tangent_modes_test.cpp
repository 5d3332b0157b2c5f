// SPDX-License-Identifier: Apache-2.0
// The published tangents against their brute force, and what making tangents perpendicular takes away.
#include <gtest/gtest.h>

#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

AttributeOptions published_tangents() {
    AttributeOptions options = published();
    options.tangent_mode = TangentMode::published;
    return options;
}

struct Frame {
    dvec3 n, t, b;
};

// Every vertex against every face of every object (all in one space): unit vectors, summed, divided, normalized, t made
// perpendicular to n, and turned where it disagrees with b.
Frame brute_force(const std::vector<Shape>& shapes, vec3 at, bool handedness = true) {
    Frame sum;
    double count = 0;
    for (const Shape& s : shapes)
        for (std::size_t i = 0; i < s.indices.size(); i += 3) {
            const auto p = [&](std::size_t k) { return s.positions[s.indices[i + k]]; };
            const auto q = [&](std::size_t k) { return s.texcoords[s.indices[i + k]]; };
            if (!(p(0) == at) && !(p(1) == at) && !(p(2) == at)) continue;
            const dvec3 e1 = cast<double>(p(1)) - cast<double>(p(0)), e2 = cast<double>(p(2)) - cast<double>(p(0));
            const double du1 = double(q(1).x) - q(0).x, dv1 = double(q(1).y) - q(0).y, du2 = double(q(2).x) - q(0).x,
                         dv2 = double(q(2).y) - q(0).y;
            const double det = du1 * dv2 - du2 * dv1;
            if (cross(e1, e2) == dvec3{}) continue;
            sum.n += normalize_or(cross(e1, e2), dvec3{});
            count += 1;
            if (det == 0) continue;
            sum.t += normalize_or((e1 * dv2 - e2 * dv1) / det, dvec3{});
            sum.b += normalize_or((e1 * du2 - e2 * du1) / det, dvec3{});  // -dP/dv
        }
    Frame f{normalize_or(sum.n / count, dvec3{}), normalize_or(sum.t / count, dvec3{}),
            normalize_or(sum.b / count, dvec3{})};
    f.t = normalize_or(f.t - f.n * dot(f.n, f.t), dvec3{});
    if (handedness && dot(cross(f.n, f.t), f.b) < 0) f.t = -f.t;
    return f;
}

// A bent sheet with a texture that runs askew and, in its right half, mirrored.
Shape askew_sheet(bool mirrored) {
    Shape s = make_grid(8, 6, [](double u, double v) {
        return vec3{float(u), float(0.3 * std::sin(4 * u + v)), float(-v)};
    });
    for (std::size_t v = 0; v < s.positions.size(); ++v) {
        const vec3 p = s.positions[v];
        const float u = mirrored ? std::fabs(p.x - 0.5f) : p.x;
        s.texcoords[v] = {u + 0.3f * p.z, p.z + 0.1f * u * u};
    }
    return s;
}

TEST(PublishedTangents, EqualTheBruteForceOverAllObjects) {
    for (const bool mirrored : {false, true}) {
        const auto parts = cut_at_random(askew_sheet(mirrored), 3, 9);
        const auto out = compute(parts, published_tangents());
        std::size_t compared = 0;
        for (std::size_t m = 0; m < parts.size(); ++m) {
            ASSERT_EQ(out[m].tangents.size(), parts[m].positions.size()) << "no vertex is split";
            ASSERT_EQ(out[m].bitangents.size(), parts[m].positions.size());
            for (std::size_t v = 0; v < parts[m].positions.size(); ++v) {
                const Frame f = brute_force(parts, parts[m].positions[v]);
                if (length(f.t) < 0.5 || length(f.b) < 0.5) continue;
                ++compared;
                EXPECT_LT(length(cast<double>(out[m].normals[v]) - f.n), 1e-6) << mirrored << v;
                EXPECT_LT(length(cast<double>(out[m].tangents[v].xyz()) - f.t), 1e-5) << mirrored << v;
                EXPECT_LT(length(cast<double>(out[m].bitangents[v]) - f.b), 1e-5) << mirrored << v;
                EXPECT_EQ(out[m].tangents[v].w, 1.0f);
            }
        }
        EXPECT_GT(compared, 60u);
    }
}

TEST(PublishedTangents, WithoutTheHandednessStepKeepTheirDirectionAndSayTheSideInW) {
    AttributeOptions options = published_tangents();
    options.tangent_mode = TangentMode::published_no_handedness;
    const auto parts = cut_at_random(askew_sheet(true), 3, 9);
    const auto out = compute(parts, options);
    std::size_t sides[2] = {0, 0};
    for (std::size_t m = 0; m < parts.size(); ++m)
        for (std::size_t v = 0; v < parts[m].positions.size(); ++v) {
            const Frame f = brute_force(parts, parts[m].positions[v], false);
            if (length(f.t) < 0.5 || length(f.b) < 0.5) continue;
            EXPECT_LT(length(cast<double>(out[m].tangents[v].xyz()) - f.t), 1e-5) << v;
            EXPECT_LT(length(cast<double>(out[m].bitangents[v]) - f.b), 1e-5) << v;
            EXPECT_EQ(out[m].tangents[v].w, dot(cross(f.n, f.t), f.b) < 0 ? -1.0f : 1.0f);
            ++sides[out[m].tangents[v].w < 0];
        }
    EXPECT_GT(sides[0], 10u);
    EXPECT_GT(sides[1], 10u);
}

// Two squares apart, the texture of the right one mirrored along u.
std::vector<Shape> mirrored_pair(const dmat4& to_world) {
    Shape left;
    left.positions = {{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}};
    left.indices = {0, 1, 2, 0, 2, 3};
    left.texcoords = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    left.to_world = to_world;
    Shape right = left;
    for (vec3& p : right.positions) p.x += 2;
    for (vec2& q : right.texcoords) q.x = 1 - q.x;
    right.object = 1;
    return {left, right};
}

TEST(PublishedTangents, FacesWhoseMapRunsBackwardsAreCounted) {
    for (const dmat4& to_world :
         {dmat4{}, scaling(dvec3{-1, 2, 3}), translation(dvec3{5, 0, 1}) * scaling(dvec3{2, 2, -2})})
        for (const Scope scope : {Scope::face, Scope::object, Scope::model}) {
            AttributeOptions options = published_tangents();
            options.scope = scope;
            auto out = compute(mirrored_pair(to_world), options);
            const bool is_turned = determinant(upper_left(to_world)) < 0;  // then the left one is mirrored in the world
            EXPECT_EQ(out[is_turned ? 1 : 0].inverted_faces, 0u);
            EXPECT_EQ(out[is_turned ? 0 : 1].inverted_faces, 2u) << "the step turns the tangent against u";
            options.tangent_mode = TangentMode::published_no_handedness;
            out = compute(mirrored_pair(to_world), options);
            EXPECT_EQ(out[0].inverted_faces + out[1].inverted_faces, 0u);
            options.tangent_mode = TangentMode::averaged;
            EXPECT_EQ(compute(mirrored_pair(to_world), options)[1].inverted_faces, 0u);
        }
}

TEST(PublishedTangents, AreBitEqualAtOnePlaceAndForAnyNumberOfThreads) {
    const auto parts = cut_at_random(askew_sheet(true), 5, 2);
    const auto one = compute(parts, published_tangents(), 1), four = compute(parts, published_tangents(), 4);
    std::map<std::tuple<float, float, float>, std::pair<vec4, vec3>> seen;
    for (std::size_t m = 0; m < parts.size(); ++m) {
        EXPECT_EQ(one[m].tangents, four[m].tangents);
        EXPECT_EQ(one[m].bitangents, four[m].bitangents);
        for (std::size_t v = 0; v < parts[m].positions.size(); ++v) {
            const vec3 p = parts[m].positions[v];
            const std::pair<vec4, vec3> frame{one[m].tangents[v], one[m].bitangents[v]};
            const auto [at, is_new] = seen.try_emplace(std::tuple(p.x, p.y, p.z), frame);
            EXPECT_TRUE(is_new || at->second == frame);
        }
    }
}

TEST(PublishedTangents, QuadHasTheSignOfTheGltfReferenceAndABitangentUpwards) {
    Shape s;
    s.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    s.indices = {0, 1, 2, 0, 2, 3};
    s.texcoords = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    MeshAttributes out = compute({s}, published_tangents()).front();
    EXPECT_EQ(out.tangents, std::vector<vec4>(4, {1, 0, 0, 1}));
    EXPECT_EQ(out.bitangents, std::vector<vec3>(4, {0, 1, 0}));
    for (vec2& q : s.texcoords) q.x = 1 - q.x;  // mirrored: the test turns the tangent round
    out = compute({s}, published_tangents()).front();
    EXPECT_EQ(out.tangents, std::vector<vec4>(4, {1, 0, 0, 1}));
    EXPECT_EQ(out.bitangents, std::vector<vec3>(4, {0, 1, 0}));
}

TEST(PublishedTangents, ScopesHoldForThemToo) {
    const auto parts = cut_by_planes(askew_sheet(false), 2);
    AttributeOptions options = published_tangents();
    const auto place_of = [&](vec3 p) {
        for (std::size_t v = 0; v < parts[1].positions.size(); ++v)
            if (parts[1].positions[v] == p) return v;
        return std::size_t(-1);
    };
    for (const Scope scope : {Scope::object, Scope::model}) {
        options.scope = scope;
        const auto out = compute(parts, options);
        std::size_t shared = 0, equal = 0;
        for (std::size_t v = 0; v < parts[0].positions.size(); ++v) {
            const std::size_t other = place_of(parts[0].positions[v]);
            if (other == std::size_t(-1)) continue;
            ++shared;
            equal += out[0].tangents[v] == out[1].tangents[other] && out[0].bitangents[v] == out[1].bitangents[other];
        }
        EXPECT_GT(shared, 3u);
        EXPECT_EQ(equal, scope == Scope::model ? shared : 0u);
    }
    options.scope = Scope::face;
    const MeshAttributes flat = compute(parts, options).front();
    EXPECT_EQ(flat.tangents.size(), parts[0].indices.size()) << "each corner its face's own";
}

TEST(PublishedTangents, KeptNormalsAreNoBorders) {
    // Two quads in one plane whose given normals differ: the sums run over the place all the same.
    Shape a, b;
    a.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    a.indices = {0, 1, 2, 0, 2, 3};
    a.texcoords = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    a.normals.assign(4, {0, 0, 1});
    b = a;
    b.object = 1;
    for (vec3& p : b.positions) p.x += 1;
    for (vec2& q : b.texcoords) q = {q.x + q.y, q.y};
    b.normals.assign(4, {0.6f, 0, 0.8f});
    AttributeOptions options = published_tangents();
    options.normals = false;
    const auto out = compute({a, b}, options);
    EXPECT_EQ(out[0].normals, a.normals);
    EXPECT_EQ(out[0].bitangents[1], out[1].bitangents[0]) << "bitangents do not know the normal";
    EXPECT_NE(out[0].bitangents[0], out[0].bitangents[1]);
}

TEST(Orthogonalize, OffLeavesTheSumAndTheLossIsItsAngle) {
    for (const TangentMode mode : {TangentMode::averaged, TangentMode::published}) {
        AttributeOptions options = published();
        options.tangent_mode = mode;
        options.measure_orthogonality = true;
        const Shape sheet = make_grid(3, 2, [](double u, double v) {
            return vec3{float(u), float(u * u + 0.8 * v * u), float(-v * v - v)};
        });
        const MeshAttributes right = compute({sheet}, options).front();
        options.orthogonalize = Orthogonalize::off;
        const MeshAttributes raw = compute({sheet}, options).front();
        double worst = 0, sum = 0;
        for (std::size_t v = 0; v < sheet.positions.size(); ++v) {
            const double skew = std::fabs(90 - degrees(angle_between(raw.normals[v], raw.tangents[v].xyz())));
            worst = std::fmax(worst, skew);
            sum += skew;
            EXPECT_NEAR(dot(right.normals[v], right.tangents[v].xyz()), 0, 1e-6);
        }
        EXPECT_GT(worst, 0.01);
        for (const MeshAttributes* out : {&right, &raw}) {
            EXPECT_NEAR(out->orthogonality_loss_max_deg, worst, 1e-3);
            EXPECT_NEAR(out->orthogonality_loss_mean_deg, sum / double(sheet.positions.size()), 1e-3);
        }
        options.measure_orthogonality = false;
        const MeshAttributes plain = compute({sheet}, options).front();
        EXPECT_EQ(plain.orthogonality_loss_max_deg, 0);
        EXPECT_EQ(plain.tangents, raw.tangents) << "measuring changes nothing";
    }
}

}  // namespace
}  // namespace rakelight::test
