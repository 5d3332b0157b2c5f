// SPDX-License-Identifier: Apache-2.0
// Meshes that are not well: degenerate, non-finite, tiny, huge, coincident shells, empty, of wrong sizes.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

void expect_sound(const Shape& s, const MeshAttributes& out) {
    ASSERT_EQ(out.normals.size(), s.positions.size() + out.source_vertex.size());
    for (const vec3 n : out.normals) EXPECT_NEAR(length(cast<double>(n)), 1, 1e-6);
    for (const vec4 t : out.tangents) EXPECT_NEAR(length(cast<double>(t.xyz())), 1, 1e-6);
    for (const std::uint32_t i : out.indices) EXPECT_LT(i, out.normals.size());
    for (const std::uint32_t v : out.source_vertex) EXPECT_LT(v, s.positions.size());
}

std::string error_of(const std::vector<Shape>& shapes, const AttributeOptions& options = {}) {
    try {
        compute(shapes, options);
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::bad_file);
        return e.what();
    }
    return "no error";
}

TEST(HardMeshes, NothingGivesNothing) {
    Context context;
    EXPECT_TRUE(compute_attributes({}, {}, context).empty());
    const auto out = compute({Shape{}, Shape{}}, {});
    ASSERT_EQ(out.size(), 2u);
    EXPECT_TRUE(out[0].normals.empty());
    Shape loose;
    loose.positions = {{1, 2, 3}, {4, 5, 6}};
    const MeshAttributes lone = compute({loose}, {}).front();
    EXPECT_EQ(lone.normals, (std::vector<vec3>{{0, 0, 1}, {0, 0, 1}}));
    EXPECT_EQ(lone.isolated_vertices, 2u);
}

TEST(HardMeshes, DegenerateTrianglesHaveNoVoteAndAreCounted) {
    for (const double crease : {60.0, 180.0}) {
        Shape s = make_hinge(1)[0];
        s.positions.push_back({0.1f, 0.1f, 0.1f});
        s.positions.push_back({0.3f, 0.3f, 0.3f});
        s.indices.insert(s.indices.end(), {0, 0, 1, 0, 4, 5, 3, 2, 3});
        AttributeOptions options;
        options.crease_angle_rad = radians(crease);
        const MeshAttributes out = compute({s}, options).front();
        expect_sound(s, out);
        EXPECT_EQ(out.degenerate_faces, 3u);
        EXPECT_EQ(out.isolated_vertices, 2u);
        EXPECT_TRUE(out.indices.empty());
        for (std::size_t v = 0; v < 4; ++v) EXPECT_EQ(out.normals[v], (vec3{0, 1, 0}));
        EXPECT_EQ(out.normals[4], (vec3{0, 0, 1}));
    }
}

TEST(HardMeshes, NonFiniteCornersLeaveTheirNeighborsAlone) {
    for (const float bad : {std::nanf(""), INFINITY, -INFINITY})
        for (const double crease : {60.0, 180.0}) {
            auto parts = make_hinge(radians(20));
            parts[0].positions.push_back({bad, 0, 0});
            parts[0].positions.push_back({bad, 0, 0});  // never welded to the other
            parts[0].indices.insert(parts[0].indices.end(), {0, 1, 4, 0, 5, 1});
            AttributeOptions options = published();
            options.crease_angle_rad = radians(crease);
            const auto out = compute(parts, options);
            expect_sound(parts[0], out[0]);
            EXPECT_EQ(out[0].degenerate_faces, 2u);
            EXPECT_EQ(out[0].normals[0], out[1].normals[0]);
            EXPECT_NEAR(degrees(angle_between(out[0].normals[0], vec3{0, 1, 0})), 10, 1e-4);
        }
}

TEST(HardMeshes, TinyAndHugeEdgesGiveTheSameNormals) {
    const Shape sphere = make_sphere(24, 12);
    for (const CornerWeight weight :
         {CornerWeight::uniform, CornerWeight::area, CornerWeight::angle, CornerWeight::angle_area, CornerWeight::max})
        for (const double crease : {60.0, 180.0}) {
            AttributeOptions options;
            options.weight = weight;
            options.crease_angle_rad = radians(crease);
            const MeshAttributes plain = compute({sphere}, options).front();
            for (const float size : {1e-20f, 1e-12f, 1e15f, 1e30f}) {
                Shape scaled = sphere;
                for (vec3& p : scaled.positions) p = p * size;
                const MeshAttributes out = compute({scaled}, options).front();
                for (std::size_t v = 25; v < 25 * 12; ++v) {
                    EXPECT_LT(angle_between(out.normals[v], plain.normals[v]), 1e-5) << size;
                    EXPECT_LT(angle_between(out.tangents[v].xyz(), plain.tangents[v].xyz()), 1e-4) << size;
                }
            }
            for (const double size : {1e-30, 1e30}) {  // by the matrix
                Shape scaled = sphere;
                scaled.to_world = scaling(dvec3{size, size, size});
                const MeshAttributes out = compute({scaled}, options).front();
                for (std::size_t v = 25; v < 25 * 12; ++v)
                    EXPECT_LT(angle_between(out.normals[v], plain.normals[v]), 1e-5);
            }
        }
}

TEST(HardMeshes, NegativeZeroIsZero) {
    auto parts = make_hinge(radians(30));
    for (vec3& p : parts[1].positions) {
        if (p.x == 0) p.x = -0.0f;
        if (p.y == 0) p.y = -0.0f;
        if (p.z == 0) p.z = -0.0f;
    }
    for (const double crease : {60.0, 180.0}) {
        AttributeOptions options;
        options.crease_angle_rad = radians(crease);
        const auto out = compute(parts, options);
        EXPECT_EQ(out[0].normals[0], out[1].normals[0]);
        EXPECT_EQ(out[0].normals[1], out[1].normals[1]);
    }
}

Shape inside_out(Shape s) {
    for (std::size_t i = 0; i < s.indices.size(); i += 3) std::swap(s.indices[i + 1], s.indices[i + 2]);
    return s;
}

// Sphere, cube and flat sheet with their inside-out twins, as objects of their own and as one mesh with common vertices.
TEST(HardMeshes, OppositeCoincidentShellsDoNotCancel) {
    const Shape flat = make_grid(4, 4, [](double u, double v) { return vec3{float(u), 0, float(-v)}; });
    for (const Shape& outer : {make_sphere(16, 8), make_cube(), flat}) {
        const MeshAttributes alone = compute({outer}, published()).front();
        Shape inner = inside_out(outer);
        inner.object = 1;
        const auto apart = compute({outer, inner}, published());
        for (std::size_t v = 0; v < outer.positions.size(); ++v) {
            EXPECT_LT(angle_between(apart[0].normals[v], alone.normals[v]), 1e-6);
            EXPECT_LT(angle_between(apart[1].normals[v], -alone.normals[v]), 1e-6);
        }
        Shape both = outer;
        both.indices.insert(both.indices.end(), inner.indices.begin(), inner.indices.end());
        const MeshAttributes together = compute({both}, published()).front();
        expect_sound(both, together);
        for (std::size_t i = 0; i < both.indices.size(); ++i) {
            if (edge_product(both, i / 3) == dvec3{}) continue;  // at the sphere's poles
            const vec3 expected = alone.normals[both.indices[i]];
            const vec3 n = corner_normal(both, together, i);
            EXPECT_LT(angle_between(n, i < outer.indices.size() ? expected : -expected), 1e-6) << i;
        }
    }
}

TEST(HardMeshes, SidesOfAShellAreSmoothOverTheirParts) {
    const Shape sphere = make_sphere(16, 8);
    auto parts = cut_by_planes(sphere, 2);
    Shape inner = inside_out(sphere);
    inner.object = 2;
    parts.push_back(inner);
    const auto out = compute(parts, published());
    std::size_t shared = 0;
    for (std::size_t a = 0; a < parts[0].positions.size(); ++a)
        for (std::size_t b = 0; b < parts[1].positions.size(); ++b)
            if (parts[0].positions[a] == parts[1].positions[b] && std::fabs(parts[0].positions[a].y) < 0.99f) {
                EXPECT_EQ(out[0].normals[a], out[1].normals[b]);
                ++shared;
            }
    EXPECT_GT(shared, 6u);
}

TEST(HardMeshes, ThreeFacesWhoseNormalsCancelAreLeftFlat) {
    // About one edge at 120 degrees each, all turning the same way: any common normal would be noise.
    Shape s;
    s.positions = {{0, 0, 0}, {0, 0, 1}};
    for (int i = 0; i < 3; ++i) {
        const double a = 2 * pi * i / 3;
        s.positions.push_back({float(std::cos(a)), float(std::sin(a)), 0.5f});
        s.indices.insert(s.indices.end(), {0, 1, std::uint32_t(2 + i)});
    }
    const MeshAttributes out = compute({s}, published()).front();
    expect_sound(s, out);
    for (std::size_t i = 0; i < 9; i += 3)
        EXPECT_LT(angle_between(corner_normal(s, out, i), corner_normal(s, out, i + 2)), 0.02);
}

TEST(HardMeshes, FlatteningMatrixGivesSoundVectors) {
    Shape sphere = make_sphere(12, 6);
    for (const dvec3 scale : {dvec3{1, 0, 1}, dvec3{0, 0, 1}, dvec3{0, 0, 0}}) {
        sphere.to_world = scaling(scale);
        for (const double crease : {60.0, 180.0}) {
            AttributeOptions options;
            options.crease_angle_rad = radians(crease);
            const MeshAttributes out = compute({sphere}, options).front();
            expect_sound(sphere, out);
        }
    }
}

TEST(HardMeshes, RandomRubbishGivesSoundVectors) {
    std::mt19937 random(21);
    const float values[] = {0.0f,  -0.0f, 1.0f,     -1.0f,         1e-38f, 1e-45f,
                            3e38f, 0.1f,  INFINITY, std::nanf(""), 1e20f,  2.0f};
    const auto pick = [&] { return values[random() % std::size(values)]; };
    for (int round = 0; round < 300; ++round) {
        std::vector<Shape> shapes(1 + random() % 3);
        for (Shape& s : shapes) {
            s.object = random() % 2;
            for (int v = 0; v < 12; ++v) {
                s.positions.push_back({pick(), pick(), pick()});
                s.texcoords.push_back({pick(), pick()});
            }
            for (int i = 0; i < 90; ++i) s.indices.push_back(random() % 12);
            if (random() % 2 == 0) {
                s.kind = random() % 2 == 0 ? GroupKind::masks : GroupKind::numbers;
                for (int t = 0; t < 30; ++t) s.smoothing.push_back(random() % 4);
            } else if (random() % 3 == 0) {
                for (int i = 0; i < 90; ++i) s.hints.push_back({pick(), pick(), pick()});
            }
            if (random() % 3 == 0) s.to_world = random_affine(random, random() % 2 == 0);
        }
        AttributeOptions options;
        options.scope = Scope(random() % 3);
        options.weight = CornerWeight(random() % 4);
        options.crease_angle_rad = radians(double(random() % 5) * 45);
        const auto out = compute(shapes, options);
        for (std::size_t m = 0; m < shapes.size(); ++m) expect_sound(shapes[m], out[m]);
    }
}

TEST(HardMeshes, ManyTinyObjectsAreOneModel) {
    const Shape sphere = make_sphere(120, 60);
    const auto parts = cut(sphere, 7200, [](std::size_t t) { return std::uint32_t(t / 2); });
    const auto out = compute(parts, published());
    std::map<std::tuple<float, float, float>, vec3> seen;
    for (std::size_t m = 0; m < parts.size(); ++m)
        for (std::size_t v = 0; v < parts[m].positions.size(); ++v) {
            const vec3 p = parts[m].positions[v];
            const auto [at, is_new] =
                seen.try_emplace(std::tuple(p.x + 0.0f, p.y + 0.0f, p.z + 0.0f), out[m].normals[v]);
            EXPECT_TRUE(is_new || at->second == out[m].normals[v]);
        }
    EXPECT_EQ(seen.size(), 120u * 59 + 2);
}

TEST(HardMeshes, WrongSizesAreNamed) {
    const Shape good = make_hinge(1)[0];
    Shape bad = good;
    bad.indices.pop_back();
    EXPECT_EQ(error_of({good, bad}), "mesh 1: 5 indices, not a multiple of 3");
    bad = good;
    bad.texcoords.resize(3);
    EXPECT_EQ(error_of({bad}), "mesh 0: 3 texture coordinates for 4 vertices");
    bad = good;
    bad.normals.resize(5);
    EXPECT_EQ(error_of({bad}), "mesh 0: 5 normals for 4 vertices");
    bad = good;
    bad.smoothing.resize(3);
    EXPECT_EQ(error_of({bad}), "mesh 0: 3 smoothing groups for 2 triangles");
    bad = good;
    bad.hints.resize(7);
    EXPECT_EQ(error_of({bad}), "mesh 0: 7 smoothing hints for 6 corners");
    AttributeOptions keep;
    keep.normals = false;
    EXPECT_EQ(error_of({good}, keep), "mesh 0: no normals to keep");
}

TEST(HardMeshes, FirstIndexOutOfRangeIsNamed) {
    const Shape good = make_hinge(1)[0];
    Shape bad = good;
    bad.indices[4] = 4711;
    bad.indices[5] = 5000;
    EXPECT_EQ(error_of({good, bad}), "mesh 1: index 4711 at corner 4 exceeds 4 vertices");
    bad = good;
    bad.positions.clear();
    EXPECT_EQ(error_of({bad}), "mesh 0: index 0 at corner 0 exceeds 0 vertices");
}

TEST(HardMeshes, MatrixMustBeFinite) {
    Shape bad = make_cube();
    bad.to_world[3].y = std::numeric_limits<double>::infinity();
    EXPECT_EQ(error_of({bad}), "mesh 0: the matrix to the world is not finite");
}

TEST(HardMeshes, CreaseAngleMustBeInRange) {
    AttributeOptions options;
    for (const double bad : {-0.1, 3.2, std::numeric_limits<double>::quiet_NaN()}) {
        options.crease_angle_rad = bad;
        EXPECT_THROW(compute({make_cube()}, options), Error);
    }
}

TEST(HardMeshes, MemoryLimitAndCancelAreObeyed) {
    const Shape sphere = make_sphere(64, 32);
    const std::vector<AttributeMesh> meshes{sphere.view()};
    Context tight({.threads = 1, .max_memory = 1000});
    EXPECT_THROW(compute_attributes(meshes, {}, tight), Error);
    Context cancelled({.threads = 1});
    cancelled.cancel();
    EXPECT_THROW(compute_attributes(meshes, {}, cancelled), Error);
}

// Triangles whose corners lie anywhere in the mesh send all their votes to other parts of it: many times the vertices' memory.
TEST(HardMeshes, VotesOfTrianglesInDisorderAreWithinTheMemoryLimit) {
    Shape soup;
    std::mt19937 random(7);
    const auto coordinate = [&] { return float(random() % 1000) / 1000; };
    for (int v = 0; v < 20000; ++v) soup.positions.push_back({coordinate(), coordinate(), coordinate()});
    for (int c = 0; c < 3 * 400000; ++c) soup.indices.push_back(random() % 20000);
    const std::vector<AttributeMesh> meshes{soup.view()};
    for (const CornerWeight weight :
         {CornerWeight::uniform, CornerWeight::area}) {  // the fast path and the general one
        AttributeOptions options = published();
        options.weight = weight;
        options.weld_distance = 0;
        std::string message;
        Context tight({.threads = 2, .max_memory = 9'000'000});
        try {
            compute_attributes(meshes, options, tight);
        } catch (const Error& e) {
            message = e.what();
        }
        EXPECT_NE(message.find("triangles in disorder"), message.npos) << message;
        EXPECT_EQ(tight.memory().charged(), 0u);
        Context wide({.threads = 2, .max_memory = 100'000'000});
        EXPECT_EQ(compute_attributes(meshes, options, wide)[0].normals.size(), soup.positions.size());
        EXPECT_EQ(wide.memory().charged(), 0u);
    }
}

}  // namespace
}  // namespace rakelight::test
