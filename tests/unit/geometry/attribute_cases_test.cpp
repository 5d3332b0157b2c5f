// SPDX-License-Identifier: Apache-2.0
// One test for each row of the table of hard cases, under the row's name, at the door; other files look at most of them
// more closely. Here: faces, coordinates and placement; connections and options: attribute_case_options_test.cpp. What
// a scene makes of instances, skins and morph targets: tests/unit/prepare.
#include "unit/geometry/attribute_cases.h"

namespace rakelight::test {
namespace {

TEST(AttributeCases, DegenerateTriangle) {
    Shape s = quad();
    s.positions.push_back({5, 5, 5});
    s.texcoords.push_back({0, 0});
    s.indices.insert(s.indices.end(), {0, 1, 1, 4, 4, 4});
    for (const TangentMode mode : all_modes) {
        AttributeOptions options;
        options.tangent_mode = mode;
        const MeshAttributes out = compute({s}, options).front();
        expect_finite(out);
        EXPECT_EQ(out.degenerate_faces, 2u);
        EXPECT_EQ(out.isolated_vertices, 1u);
        EXPECT_EQ(out.normals[1], (vec3{0, 0, 1}));
        EXPECT_EQ(out.normals[4], (vec3{0, 0, 1})) << "the documented fallback";
    }
}

TEST(AttributeCases, TinyAndHugeEdges) {
    for (const float size : {1e-20f, 1e15f})
        for (const TangentMode mode : all_modes) {
            Shape s = quad();
            for (vec3& p : s.positions) p = p * size;
            AttributeOptions options;
            options.tangent_mode = mode;
            const MeshAttributes out = compute({s}, options).front();
            for (const vec3 n : out.normals) EXPECT_EQ(n, (vec3{0, 0, 1})) << size;
            for (const vec4 t : out.tangents) {
                EXPECT_NEAR(t.x, 1, 1e-6) << size;
                EXPECT_EQ(t.w, 1) << size;
            }
        }
}

TEST(AttributeCases, NanAndInfinitePosition) {
    for (const float bad : {std::nanf(""), INFINITY})
        for (const TangentMode mode : all_modes) {
            Shape s = quad();
            s.positions.push_back({bad, 0, 0});
            s.texcoords.push_back({2, 2});
            s.indices.insert(s.indices.end(), {0, 1, 4, 4, 2, 3});
            AttributeOptions options = published();
            options.tangent_mode = mode;
            const MeshAttributes out = compute({s}, options).front();
            expect_finite(out);
            EXPECT_EQ(out.degenerate_faces, 2u);
            for (std::size_t v = 0; v < 4; ++v) EXPECT_EQ(out.normals[v], (vec3{0, 0, 1}));
            for (std::size_t v = 0; v < 4; ++v) EXPECT_NEAR(out.tangents[v].x, 1, 1e-6);
        }
}

TEST(AttributeCases, NegativeZeroEqualsZero) {
    auto parts = make_hinge(radians(40));
    for (vec3& p : parts[1].positions) p = {p.x == 0 ? -0.0f : p.x, p.y == 0 ? -0.0f : p.y, p.z == 0 ? -0.0f : p.z};
    const auto out = compute(parts, published());
    EXPECT_EQ(out[0].normals[0], out[1].normals[0]);
    EXPECT_NEAR(degrees(angle_between(out[0].normals[0], vec3{0, 1, 0})), 20, 1e-4);
}

TEST(AttributeCases, ZeroAreaUv) {
    // The second triangle has none; its own vertex has nothing else.
    Shape s = quad();
    s.texcoords = {{0, 1}, {1, 1}, {1, 0}, {0.5f, 0.5f}};
    for (const TangentMode mode : all_modes) {
        AttributeOptions options;
        options.tangent_mode = mode;
        MeshAttributes out = compute({s}, options).front();
        expect_finite(out);
        for (std::size_t v = 0; v < 3; ++v) EXPECT_NEAR(out.tangents[v].x, 1, 1e-6) << "excluded from the sums";
        for (vec2& q : s.texcoords) q = {0.5f, 0.5f};
        for (vec3& p : s.positions) p = {p.z, p.x, p.y};  // faces +X
        out = compute({s}, options).front();
        for (std::size_t v = 0; v < 4; ++v) {
            EXPECT_EQ(out.normals[v], (vec3{1, 0, 0}));
            EXPECT_EQ(out.tangents[v], (vec4{0, 1, 0, 1})) << "the axis farthest from the normal";
        }
        s = quad();
        s.texcoords = {{0, 1}, {1, 1}, {1, 0}, {0.5f, 0.5f}};
    }
}

TEST(AttributeCases, MirroredUvsAtOnePosition) {
    Shape s;
    s.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, 1, 0}};
    s.texcoords = {{0, 1}, {0, 0}, {1, 1}, {1, 0}, {1, 1}, {1, 0}};
    s.indices = {0, 2, 3, 0, 3, 1, 4, 0, 1, 4, 1, 5};
    for (const TangentMode mode : {TangentMode::averaged, TangentMode::mikktspace}) {
        AttributeOptions options;
        options.tangent_mode = mode;
        const MeshAttributes out = compute({s}, options).front();
        EXPECT_EQ(out.source_vertex, (std::vector<std::uint32_t>{0, 1})) << "split by handedness";
        for (std::size_t i = 0; i < 12; ++i)
            EXPECT_EQ(out.tangents[output_vertex(s, out, i)], i < 6 ? (vec4{1, 0, 0, 1}) : (vec4{-1, 0, 0, -1})) << i;
    }
}

TEST(AttributeCases, OppositeCoincidentFaces) {
    const Shape sheet = make_grid(6, 6, [](double u, double v) {
        return vec3{float(u), float(0.2 * std::sin(3 * u)), float(-v)};
    });
    Shape back = inside_out(sheet);
    back.object = 1;
    for (const double deg : {60.0, 180.0}) {
        const auto out = compute({sheet, back}, crease(deg));
        const auto alone = compute({sheet}, crease(deg));
        for (std::size_t v = 0; v < sheet.positions.size(); ++v) {
            EXPECT_LT(angle_between(out[0].normals[v], alone[0].normals[v]), 1e-6);
            EXPECT_LT(angle_between(out[1].normals[v], -alone[0].normals[v]), 1e-6);
        }
    }
}

TEST(AttributeCases, OppositeFacesThatAreTriangulatedDifferently) {
    const Shape sheet = make_grid(6, 6, [](double u, double v) { return vec3{float(u), 0, float(-v)}; });
    Shape back = inside_out(sheet);
    back.object = 1;
    for (std::size_t q = 0; q < back.indices.size(); q += 6) {  // the other diagonal of each square
        const std::uint32_t a = back.indices[q], e = back.indices[q + 1], b = back.indices[q + 2],
                            d = back.indices[q + 4];
        const std::uint32_t turned[] = {a, d, b, b, d, e};
        std::copy_n(turned, 6, back.indices.begin() + std::ptrdiff_t(q));
    }
    ASSERT_NE(edge_product(back, 0), dvec3{});
    // Joined by 180 degrees only angles, which do not see the diagonals, cancel; below, every weight leaves the sides apart.
    for (const CornerWeight weight :
         {CornerWeight::angle, CornerWeight::uniform, CornerWeight::area, CornerWeight::angle_area, CornerWeight::max})
        for (const double deg : {60.0, 180.0}) {
            if (deg == 180 && weight != CornerWeight::angle) continue;
            AttributeOptions options = crease(deg);
            options.weight = weight;
            const auto out = compute({sheet, back}, options);
            for (std::size_t v = 0; v < sheet.positions.size(); ++v) {
                EXPECT_EQ(out[0].normals[v], (vec3{0, 1, 0})) << deg << " vertex " << v;
                EXPECT_EQ(out[1].normals[v], (vec3{0, -1, 0})) << deg << " vertex " << v;
            }
        }
}

TEST(AttributeCases, NearCoincident) {
    auto parts = make_hinge(radians(30));
    for (vec3& p : parts[1].positions) p.x += 1e-7f;
    AttributeOptions exact = published(), within = published();
    exact.weld_distance = 0;
    within.weld_distance = 1e-6;
    const auto two = compute(parts, exact), one = compute(parts, within);
    EXPECT_NEAR(degrees(angle_between(two[0].normals[0], two[1].normals[0])), 30, 1e-4) << "a real seam";
    EXPECT_EQ(one[0].normals[0], one[1].normals[0]);
}

TEST(AttributeCases, Transforms) {
    // One sheet by the identity, its neighbor stored elsewhere by a matrix that mirrors and stretches.
    std::mt19937 random(4);
    for (int round = 0; round < 20; ++round) {
        const dmat4 m = random_affine(random, round % 2 == 1);
        dmat4 back;
        ASSERT_TRUE(inverse_affine(m, back));
        auto parts = make_hinge(radians(50));
        for (vec3& p : parts[1].positions) p = cast<float>(transform_point(back, cast<double>(p)));
        if (round % 2 == 1) parts[1] = inside_out(parts[1]);  // the matrix turns it round once more
        parts[1].to_world = m;
        AttributeOptions options = published();
        options.weld_distance = 1e-5;
        const auto out = compute(parts, options);
        const dvec3 n = cofactor(upper_left(m)) * cast<double>(out[1].normals[0]) * (round % 2 == 1 ? -1.0 : 1.0);
        EXPECT_LT(degrees(angle_between(normalize_or(n, dvec3{}), cast<double>(out[0].normals[0]))), 1e-3) << round;
    }
    Shape singular = quad();
    singular.to_world = scaling(dvec3{1, 0, 1});
    expect_finite(compute({singular}, {}).front());
    singular.to_world[0][0] = std::nan("");
    EXPECT_THROW(compute({singular}, {}), Error);
}

TEST(AttributeCases, EqualWorldPointsFromDifferentMatrices) {
    auto parts = make_hinge(radians(50));
    const dmat4 m = translation(dvec3{0.1, 0.7, -0.3});
    dmat4 back;
    ASSERT_TRUE(inverse_affine(m, back));
    for (vec3& p : parts[1].positions) p = cast<float>(transform_point(back, cast<double>(p)));
    parts[1].to_world = m;
    const auto by_default = compute(parts, published());
    EXPECT_LT(degrees(angle_between(by_default[0].normals[0], by_default[1].normals[0])), 1e-4);
}

TEST(AttributeCases, Instancing) {
    // One mesh placed twice: beside a neighbor, and alone. Each place gets normals of its own in the mesh's space.
    const auto hinge = make_hinge(radians(50));
    Shape alone = hinge[0];
    alone.to_world = translation(dvec3{0, 7, 0});
    alone.object = 2;
    const auto out = compute({hinge[0], hinge[1], alone}, published());
    EXPECT_EQ(out[0].normals[0], out[1].normals[0]);
    EXPECT_NEAR(degrees(angle_between(out[0].normals[0], vec3{0, 1, 0})), 25, 1e-4);
    EXPECT_EQ(out[2].normals[0], (vec3{0, 1, 0}));
    EXPECT_EQ(out[0].normals[2], out[2].normals[2]) << "away from the neighbor they agree";
}

TEST(AttributeCases, SkinningAndMorphs) {
    // Grouped in the bind pose once; in each pose the border stays closed, whatever the crease angle would say to it.
    const auto bind = make_hinge(radians(20));
    Context context({.threads = 2});
    const AttributePlan plan = group(views(bind), crease(30), context);
    for (const double bend : {0.0, 50.0, 90.0, 150.0}) {
        const auto posed = make_hinge(radians(bend));
        const auto out = accumulate(plan, views(posed), context);
        EXPECT_EQ(out[0].normals[0], out[1].normals[0]) << bend;
        EXPECT_NEAR(degrees(angle_between(out[0].normals[0], vec3{0, 1, 0})), bend / 2, 1e-3) << bend;
        EXPECT_EQ(out[0].normals[2], (vec3{0, 1, 0})) << bend;
    }
}

}  // namespace
}  // namespace rakelight::test
