// SPDX-License-Identifier: Apache-2.0
// Tangents: sign conventions, mirrored texture coordinates, charts that lie differently, fallbacks, transforms.
#include <gtest/gtest.h>

#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

// A quad facing +Z; u to +X and, seen in the picture, v downwards.
Shape make_quad() {
    Shape s;
    s.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    s.indices = {0, 1, 2, 0, 2, 3};
    s.texcoords = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    return s;
}

dvec3 bitangent(vec3 n, vec4 t) { return cross(cast<double>(n), cast<double>(t.xyz())) * double(t.w); }

void expect_frame(const MeshAttributes& out) {
    ASSERT_EQ(out.tangents.size(), out.normals.size());
    for (std::size_t v = 0; v < out.normals.size(); ++v) {
        const dvec3 n = cast<double>(out.normals[v]), t = cast<double>(out.tangents[v].xyz());
        EXPECT_NEAR(length(n), 1, 1e-6);
        EXPECT_NEAR(length(t), 1, 1e-6);
        EXPECT_NEAR(dot(n, t), 0, 1e-6);
        EXPECT_EQ(std::fabs(out.tangents[v].w), 1.0f);
    }
}

TEST(Tangents, QuadHasTheSignOfTheGltfReference) {
    const MeshAttributes out = compute({make_quad()}, {}).front();
    for (const vec4 t : out.tangents) EXPECT_EQ(t, (vec4{1, 0, 0, 1}));
    for (const vec3 n : out.normals) EXPECT_EQ(bitangent(n, out.tangents[0]), (dvec3{0, 1, 0}));  // -dP/dv
}

TEST(Tangents, MirroredTextureFlipsTangentAndSign) {
    Shape quad = make_quad();
    for (vec2& q : quad.texcoords) q.x = 1 - q.x;
    const MeshAttributes out = compute({quad}, {}).front();
    for (const vec4 t : out.tangents) EXPECT_EQ(t, (vec4{-1, 0, 0, -1}));
}

TEST(Tangents, AreEmptyWithoutTextureCoordinatesAndWhenNotAskedFor) {
    Shape quad = make_quad();
    AttributeOptions options;
    options.tangents = false;
    EXPECT_TRUE(compute({quad}, options).front().tangents.empty());
    quad.texcoords.clear();
    EXPECT_TRUE(compute({quad}, {}).front().tangents.empty());
}

TEST(Tangents, VertexBetweenMirroredHalvesIsSplit) {
    // u grows from the middle to both sides: the two middle vertices need two tangents, one normal.
    Shape s;
    s.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, 1, 0}};
    s.texcoords = {{0, 1}, {0, 0}, {1, 1}, {1, 0}, {1, 1}, {1, 0}};
    s.indices = {0, 2, 3, 0, 3, 1, 4, 0, 1, 4, 1, 5};
    const MeshAttributes out = compute({s}, {}).front();
    EXPECT_EQ(out.normals.size(), 8u);
    EXPECT_EQ(out.source_vertex, (std::vector<std::uint32_t>{0, 1}));
    expect_frame(out);
    for (std::size_t i = 0; i < s.indices.size(); ++i) {
        const vec4 t = out.tangents[output_vertex(s, out, i)];
        EXPECT_EQ(t, i < 6 ? (vec4{1, 0, 0, 1}) : (vec4{-1, 0, 0, -1})) << i;
        EXPECT_EQ(corner_normal(s, out, i), (vec3{0, 0, 1}));
    }
}

TEST(Tangents, MirroredHalvesInTwoObjectsAreNotAveraged) {
    Shape right = make_quad(), left = make_quad();
    for (std::size_t v = 0; v < 4; ++v) {
        left.positions[v].x = -left.positions[v].x;
        std::swap(left.positions[v].x, right.positions[v].x);
        std::swap(left.positions[v].x, right.positions[v].x);
    }
    for (std::size_t i = 0; i < 6; i += 3) std::swap(left.indices[i], left.indices[i + 1]);
    left.object = 1;
    const auto out = compute({right, left}, {});
    for (const vec4 t : out[0].tangents) EXPECT_EQ(t, (vec4{1, 0, 0, 1}));
    for (const vec4 t : out[1].tangents) EXPECT_EQ(t, (vec4{-1, 0, 0, -1}));
}

// Two quads side by side in one plane, the right one's chart turned by an angle.
std::vector<Shape> turned_charts(double turn_deg) {
    Shape left = make_quad(), right = make_quad();
    right.object = 1;
    const double c = std::cos(radians(turn_deg)), s = std::sin(radians(turn_deg));
    for (std::size_t v = 0; v < 4; ++v) {
        right.positions[v].x += 1;
        const vec2 q = right.texcoords[v];
        right.texcoords[v] = {float(c * q.x - s * q.y), float(s * q.x + c * q.y)};
    }
    return {left, right};
}

TEST(Tangents, AreAveragedOverABorderWithinFortyFiveDegrees) {
    for (const double turn : {0.0, 20.0, 44.9}) {
        const auto out = compute(turned_charts(turn), {});
        EXPECT_EQ(out[0].tangents[1], out[1].tangents[0]) << turn;
        EXPECT_NEAR(degrees(angle_between(out[0].tangents[1].xyz(), out[0].tangents[0].xyz())), turn / 2, 0.01);
    }
    for (const double turn : {45.1, 90.0, 180.0}) {
        const auto out = compute(turned_charts(turn), {});
        EXPECT_NEAR(degrees(angle_between(out[0].tangents[1].xyz(), out[1].tangents[0].xyz())), turn, 0.01) << turn;
        EXPECT_EQ(out[0].tangents[1], (vec4{1, 0, 0, 1})) << turn;
    }
}

TEST(Tangents, PolesOfASphereKeepTheirOwn) {
    const MeshAttributes out = compute({make_sphere(48, 24)}, published()).front();
    expect_frame(out);
    // 49 vertices stand at the pole, their tangents all around: their sum vanishes.
    double widest = 0;
    for (std::size_t v = 1; v < 48; ++v)
        widest = std::fmax(widest, angle_between(out.tangents[0].xyz(), out.tangents[v].xyz()));
    EXPECT_GT(widest, radians(150));
}

TEST(Tangents, FollowTheRingsOfASphereAcrossItsTextureSeamAndParts) {
    const Shape whole = make_sphere(48, 24);
    for (const auto& parts : {cut_by_planes(whole, 4), cut_at_random(whole, 4, 2)}) {
        const auto out = compute(parts, published());
        std::map<std::tuple<float, float, float>, vec4> seen;
        for (std::size_t m = 0; m < parts.size(); ++m) {
            expect_frame(out[m]);
            for (std::size_t v = 0; v < parts[m].positions.size(); ++v) {
                const vec3 p = parts[m].positions[v];
                if (std::fabs(p.y) > 0.9f) continue;
                const auto [at, is_new] =
                    seen.try_emplace(std::tuple(p.x + 0.0f, p.y + 0.0f, p.z + 0.0f), out[m].tangents[v]);
                EXPECT_TRUE(is_new || at->second == out[m].tangents[v]);
                const dvec3 truth = normalize_or(dvec3{p.z, 0, -double(p.x)}, dvec3{});
                EXPECT_LT(degrees(angle_between(cast<double>(out[m].tangents[v].xyz()), truth)), 3);
                EXPECT_EQ(out[m].tangents[v].w, -1.0f);  // v grows upwards here, dP/du x dP/dv points outwards
            }
        }
    }
}

TEST(Tangents, ZeroAreaTextureGetsTheFixedPerpendicular) {
    Shape quad = make_quad();
    for (vec2& q : quad.texcoords) q = {0.5f, 0.5f};
    const MeshAttributes flat = compute({quad}, {}).front();
    expect_frame(flat);
    for (const vec4 t : flat.tangents) EXPECT_EQ(t, (vec4{1, 0, 0, 1}));
    for (vec3& p : quad.positions) p = {p.z, p.x, p.y};  // now the normal is +X: the axis farthest from it is Y
    const MeshAttributes turned = compute({quad}, {}).front();
    for (const vec4 t : turned.tangents) EXPECT_EQ(t, (vec4{0, 1, 0, 1}));
}

TEST(Tangents, FaceWithoutTextureAreaHasNoVoteAndSplitsNothing) {
    Shape s = make_quad();
    s.texcoords[3] = s.texcoords[2] = {1, 0};
    s.texcoords[0] = {0, 1};
    s.indices = {0, 1, 2, 0, 2, 3};
    const MeshAttributes out = compute({s}, {}).front();
    EXPECT_TRUE(out.indices.empty());
    expect_frame(out);
    EXPECT_EQ(out.tangents[0], (vec4{1, 0, 0, 1}));
}

TEST(Tangents, NonFiniteTextureCoordinatesHaveNoVote) {
    for (const float bad : {std::nanf(""), INFINITY, -INFINITY, 3e38f}) {
        Shape s = make_quad();
        s.texcoords[3] = {bad, -bad};
        const MeshAttributes out = compute({s}, {}).front();
        expect_frame(out);
        EXPECT_EQ(out.tangents[1], (vec4{1, 0, 0, 1}));
    }
}

TEST(Tangents, MirroredMatrixKeepsTheObjectsOwnSign) {
    Shape quad = make_quad();
    quad.to_world = scaling(dvec3{-2, 1, 3});
    const MeshAttributes out = compute({quad}, {}).front();
    for (const vec4 t : out.tangents) EXPECT_EQ(t, (vec4{1, 0, 0, 1}));
    for (const vec3 n : out.normals) EXPECT_EQ(n, (vec3{0, 0, 1}));
}

TEST(Tangents, SkewedObjectKeepsItsFrameInItsOwnSpace) {
    std::mt19937 random(8);
    for (int i = 0; i < 20; ++i) {
        Shape quad = make_quad();
        quad.to_world = random_affine(random, i % 2 == 0);
        const MeshAttributes out = compute({quad}, {}).front();
        expect_frame(out);
        for (const vec4 t : out.tangents) {
            EXPECT_NEAR(t.x, 1, 1e-6);
            EXPECT_EQ(t.w, 1.0f);
        }
    }
}

TEST(Tangents, GivenNormalsAreKeptToTheBit) {
    Shape sphere = make_sphere(16, 8);
    for (const vec3 p : sphere.positions) sphere.normals.push_back(normalize_or(p, vec3{0, 0, 1}));
    AttributeOptions options;
    options.normals = false;
    const MeshAttributes out = compute({sphere}, options).front();
    EXPECT_EQ(out.normals, sphere.normals);
    EXPECT_TRUE(out.indices.empty());
    expect_frame(out);
    for (std::size_t v = 17; v < 17 * 8; v += 17)
        EXPECT_EQ(out.tangents[v], out.tangents[v + 16]);  // over the texture seam
}

TEST(Tangents, GivenNormalsThatPointInwardsTurnTheSign) {
    Shape quad = make_quad();
    quad.normals.assign(4, {0, 0, -1});
    AttributeOptions options;
    options.normals = false;
    const MeshAttributes out = compute({quad}, options).front();
    for (std::size_t v = 0; v < 4; ++v) {
        EXPECT_EQ(out.tangents[v], (vec4{1, 0, 0, -1}));
        EXPECT_EQ(bitangent(out.normals[v], out.tangents[v]), (dvec3{0, 1, 0}));
    }
}

TEST(Tangents, GivenNormalsOfNoUseAreReplaced) {
    Shape quad = make_quad();
    quad.normals = {{0, 0, 0}, {std::nanf(""), 0, 1}, {0, 0, 4}, {0, 0, 1}};
    AttributeOptions options;
    options.normals = false;
    const MeshAttributes out = compute({quad}, options).front();
    expect_frame(out);
    for (const vec3 n : out.normals) EXPECT_EQ(n, (vec3{0, 0, 1}));
}

}  // namespace
}  // namespace rakelight::test
