// SPDX-License-Identifier: Apache-2.0
// The fast path against the general one, which it must equal: same topology, vectors within the rounding of float, seams
// bit-equal, the same bits for all threads and instruction sets.
#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <limits>

#include "geometry/fast/fast_attributes.h"
#include "geometry/general_attributes.h"
#include "math/isa.h"
#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

constexpr double as_general = 2e-6;  // rounding of float in the worst face that the fast path takes itself

std::vector<MeshAttributes> general(const std::vector<Shape>& shapes, const AttributeOptions& options) {
    Context context({.threads = 1});
    return geometry::general_attributes(views(shapes), options, context);
}

void expect_equal(const std::vector<MeshAttributes>& a, const std::vector<MeshAttributes>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t m = 0; m < a.size(); ++m) {
        EXPECT_EQ(a[m].normals, b[m].normals) << "mesh " << m;
        EXPECT_EQ(a[m].tangents, b[m].tangents) << "mesh " << m;
        EXPECT_EQ(a[m].indices, b[m].indices) << "mesh " << m;
        EXPECT_EQ(a[m].source_vertex, b[m].source_vertex) << "mesh " << m;
        EXPECT_EQ(a[m].degenerate_faces, b[m].degenerate_faces) << "mesh " << m;
        EXPECT_EQ(a[m].isolated_vertices, b[m].isolated_vertices) << "mesh " << m;
    }
}

void expect_as_general(const std::vector<Shape>& shapes, const AttributeOptions& options,
                       double tolerance = as_general) {
    ASSERT_TRUE(geometry::takes_fast_path(views(shapes), options));
    const auto fast = compute(shapes, options), exact = general(shapes, options);
    ASSERT_EQ(fast.size(), exact.size());
    for (std::size_t m = 0; m < fast.size(); ++m) {
        EXPECT_EQ(fast[m].indices, exact[m].indices) << "mesh " << m;
        EXPECT_EQ(fast[m].source_vertex, exact[m].source_vertex) << "mesh " << m;
        EXPECT_EQ(fast[m].degenerate_faces, exact[m].degenerate_faces) << "mesh " << m;
        EXPECT_EQ(fast[m].isolated_vertices, exact[m].isolated_vertices) << "mesh " << m;
        ASSERT_EQ(fast[m].normals.size(), exact[m].normals.size());
        ASSERT_EQ(fast[m].tangents.size(), exact[m].tangents.size());
        double worst = 0, worst_tangent = 0;
        for (std::size_t v = 0; v < fast[m].normals.size(); ++v)
            worst = std::fmax(worst, length(cast<double>(fast[m].normals[v]) - cast<double>(exact[m].normals[v])));
        for (std::size_t v = 0; v < fast[m].tangents.size(); ++v) {
            const vec4 a = fast[m].tangents[v], b = exact[m].tangents[v];
            EXPECT_EQ(a.w, b.w) << "mesh " << m << " vertex " << v;
            worst_tangent = std::fmax(worst_tangent, length(cast<double>(a.xyz()) - cast<double>(b.xyz())));
        }
        EXPECT_LE(worst, tolerance) << "mesh " << m;
        EXPECT_LE(worst_tangent, 4 * tolerance) << "mesh " << m;
    }
}

// Vertices anywhere on a coarse lattice: shared places, slivers, degenerate and opposite faces, mirrored texture in plenty.
std::vector<Shape> random_model(std::uint32_t seed, std::uint32_t meshes, std::uint32_t faces) {
    std::mt19937 random(seed);
    std::vector<Shape> all(meshes);
    for (std::uint32_t m = 0; m < meshes; ++m) {
        Shape& s = all[m];
        s.object = m / 2;
        const std::uint32_t vertices = 3 + random() % (faces + 1);
        const bool textured = random() % 4 != 0;
        for (std::uint32_t v = 0; v < vertices; ++v) {
            const auto coordinate = [&] { return float(int(random() % 7) - 3) * 0.37f; };
            s.positions.push_back({coordinate(), coordinate(), coordinate()});
            if (textured) s.texcoords.push_back({float(random() % 5) * 0.2f, float(random() % 5) * 0.2f});
        }
        for (std::uint32_t i = 0; i < 3 * faces; ++i) s.indices.push_back(random() % vertices);
    }
    return all;
}

Shape displaced(Shape s, std::uint32_t seed) {
    for (vec3& p : s.positions) {  // by a hash of the position: equal places stay equal
        std::uint32_t h = seed;
        for (const float c : {p.x, p.y, p.z})
            h = (h ^ std::bit_cast<std::uint32_t>(c + 0.0f)) * 2654435761u, h ^= h >> 15;
        p = p * (1 + float(h % 1000) * 1e-5f);
    }
    return s;
}

struct IsaGuard {
    explicit IsaGuard(const char* isa) { setenv("RAKELIGHT_ISA", isa, 1); }
    ~IsaGuard() { unsetenv("RAKELIGHT_ISA"); }
};

TEST(FastPath, EqualsTheGeneralOneOnRandomModels) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        AttributeOptions options = published();
        options.scope = seed % 3 == 0 ? Scope::object : Scope::model;
        options.tangents = seed % 5 != 0;
        expect_as_general(random_model(seed, 1 + seed % 7, 1 + seed * 3 % 97), options, 1e-5);
    }
}

TEST(FastPath, EqualsTheGeneralOneOnCutSurfaces) {
    for (const std::uint32_t parts : {1u, 2u, 16u})
        for (const Shape& whole : {make_sphere(60, 30), make_torus(50, 30), make_cylinder(40, 12), make_cube()}) {
            expect_as_general(cut_at_random(displaced(whole, parts), parts, parts), published());
            expect_as_general(cut_by_planes(displaced(whole, parts), parts), published());
        }
}

TEST(FastPath, EveryWeightAndCreaseEqualTheGeneralOnes) {
    for (const CornerWeight weight :
         {CornerWeight::uniform, CornerWeight::area, CornerWeight::angle, CornerWeight::angle_area, CornerWeight::max})
        for (const double crease : {2.0, 30.0, 60.0, 135.0, 180.0}) {
            SCOPED_TRACE(testing::Message() << int(weight) << ' ' << crease);
            AttributeOptions options = published();
            options.weight = weight;
            options.crease_angle_rad = radians(crease);
            for (const Shape& whole : {make_sphere(60, 30), make_torus(50, 30), make_cylinder(40, 12), make_cube()}) {
                expect_as_general(cut_at_random(displaced(whole, 3), 4, 3), options, 1e-5);
                expect_as_general({displaced(whole, 1)}, options, 1e-5);
            }
            for (std::uint32_t seed = 0; seed < 6; ++seed)
                expect_as_general(random_model(seed, 1 + seed % 7, 1 + seed * 9), options, 1e-4);
        }
}

TEST(FastPath, FitsEqualTheGeneralOnes) {
    for (const CornerWeight weight : {CornerWeight::fit, CornerWeight::automatic})
        for (const double crease : {30.0, 60.0, 180.0})
            for (const bool tangents : {false, true}) {
                SCOPED_TRACE(testing::Message() << int(weight) << ' ' << crease << ' ' << tangents);
                AttributeOptions options = published();
                options.weight = weight;
                options.tangents = tangents;
                options.crease_angle_rad = radians(crease);
                for (const Shape& whole :
                     {make_sphere(60, 30), make_torus(50, 30), make_cylinder(40, 12), make_cube()}) {
                    expect_as_general({displaced(whole, 1)}, options, 3e-5);
                    expect_as_general({whole}, options, 3e-5);
                    expect_as_general(cut_at_random(displaced(whole, 3), 4, 3), options, 3e-5);
                }
            }
}

// Where every bend is small, the rule of creases joins all: without it. Elsewhere the general path asks it.
TEST(FastPath, TheRuleOfCreasesIsThatOfTheGeneralPath) {
    for (const CornerWeight weight : {CornerWeight::angle, CornerWeight::automatic})
        for (const bool tangents : {false, true})
            for (const Shape& whole : {make_torus(200, 120), make_torus(50, 30), make_sphere(90, 60), make_cube(),
                                       make_cylinder(80, 4), make_cylinder(12, 4)}) {
                AttributeOptions options = published();
                options.weight = weight;
                options.tangents = tangents;
                options.creases = Creasing::automatic;
                expect_as_general({whole}, options, 3e-5);
                Shape folded = whole;  // mirrored texture, of which the general path splits vertices
                for (vec2& uv : folded.texcoords) uv.x = uv.x < 0.5f ? uv.x : 1 - uv.x;
                expect_as_general(cut_by_planes(folded, 3), options, 3e-5);
            }
}

// Charts that turn at a border between parts leave its tangents to the general path, and its bend must be seen all the same.
TEST(FastPath, TheRuleOfCreasesSeesBendsBetweenPartsOfTurnedCharts) {
    for (const double turned : {0.0, 20.0, 35.0, 45.0, 60.0, 90.0})
        for (const bool fits : {false, true}) {
            AttributeOptions options = published();
            options.weight = fits ? CornerWeight::automatic : CornerWeight::angle;
            options.creases = Creasing::automatic;
            std::vector<Shape> parts = cut_by_planes(make_torus(24, 12), 2);
            const float c = float(std::cos(radians(turned))), s = float(std::sin(radians(turned)));
            for (vec2& uv : parts[1].texcoords) uv = {c * uv.x - s * uv.y, s * uv.x + c * uv.y};
            expect_as_general(parts, options, 3e-5);
            options.creases = Creasing::angle, options.crease_angle_rad = radians(20);
            expect_as_general(parts, options, 3e-5);
        }
}

// Faces that fold over, slivers, and heights of several edges: normals alone, as tangents depend on them without bounds.
TEST(FastPath, FitsEqualTheGeneralOnesOnRubble) {
    for (const CornerWeight weight : {CornerWeight::fit, CornerWeight::automatic})
        for (const double crease : {30.0, 60.0, 180.0}) {
            AttributeOptions options = published();
            options.weight = weight;
            options.tangents = false;
            options.crease_angle_rad = radians(crease);
            expect_as_general({displaced(make_sphere(400, 300), 1)}, options, 1e-3);
            for (std::uint32_t seed = 0; seed < 20; ++seed)
                expect_as_general(random_model(seed, 1 + seed % 7, 1 + seed * 3 % 97), options, 1e-3);
        }
}

// Whether faces are flat is decided alike, though their vectors are rounded to float.
TEST(FastPath, FitsAtBordersThatAreFlatWithinRoundingEqualTheGeneralOnes) {
    Shape s;
    for (const float low : {0.0f, -0.0004f, -0.0016f})
        for (const float z : {0.005f, -0.12f, -0.495f})
            s.positions.push_back({float(s.positions.size() / 3), float(s.positions.size() % 3), z + low});
    s.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 3, 4, 7, 3, 7, 6, 4, 5, 8, 4, 8, 7};
    AttributeOptions options = published();
    options.weight = CornerWeight::automatic, options.tangents = false, options.crease_angle_rad = radians(60);
    expect_as_general({s}, options, 3e-5);
}

// A fan of `faces` around a point, `height` below it: a cone. `turned`: about the axis.
Shape fan_below(vec3 tip, std::uint32_t faces, float height, float turned, std::uint32_t object) {
    Shape s;
    s.object = object;
    s.positions.push_back(tip);
    for (std::uint32_t i = 0; i < faces; ++i) {
        const float a = turned + 6.2831853f * float(i) / float(faces);
        s.positions.push_back({tip.x + std::cos(a), tip.y + std::sin(a), tip.z - height});
        const std::uint32_t next = (i + 1) % faces;
        s.indices.insert(s.indices.end(), {0, 1 + i, 1 + next});
    }
    return s;
}

// Surfaces that touch at a point are not joined by a crease angle, though all their faces lie within it.
TEST(FastPath, SurfacesThatTouchAtAPointStayApart) {
    AttributeOptions options = published();
    options.tangents = false;
    options.crease_angle_rad = radians(60);
    for (const float turned : {0.0f, 0.1f, 0.5f})
        for (const float height : {0.0f, 0.1f, 0.2f}) {
            std::vector<Shape> two{fan_below({1, 2, 3}, 7, 0, 0, 0), fan_below({1, 2, 3}, 7, height, turned, 1)};
            expect_as_general(two, options);
            two[1].positions[3].x += 0.2f;
            expect_as_general(two, options);
            Shape one = two[0];  // the same in one mesh, of one vertex
            for (std::size_t v = 1; v < two[1].positions.size(); ++v) one.positions.push_back(two[1].positions[v]);
            for (const std::uint32_t i : two[1].indices) one.indices.push_back(i == 0 ? 0 : i + 7);
            expect_as_general({one}, options);
            one.indices.resize(one.indices.size() - 3);  // and with a gap
            expect_as_general({one}, options);
            one.indices.erase(one.indices.begin(), one.indices.begin() + 3);
            expect_as_general({one}, options);
        }
}

// Where a normal turns by half the crease angle, float and double could decide differently: a cone's tip.
TEST(FastPath, FacesNearTheCreaseAngleAreDecidedAsByTheGeneralPath) {
    AttributeOptions options = published();
    options.tangents = false;
    for (const double crease : {10.0, 60.0, 100.0})
        for (int step = -20; step <= 20; ++step) {
            options.crease_angle_rad = radians(crease);
            const double slope = radians(crease / 2) * (1 + step * 1e-4);
            for (const std::uint32_t faces : {3u, 4u, 6u, 60u})
                expect_as_general({fan_below({}, faces, float(std::tan(slope)), 0.3f, 0)}, options);
        }
}

TEST(FastPath, ScalesOfAnySizeTakeEveryWeight) {
    AttributeOptions options = published();
    options.crease_angle_rad = radians(60);
    for (const CornerWeight weight :
         {CornerWeight::area, CornerWeight::angle, CornerWeight::angle_area, CornerWeight::max})
        for (const float scale : {1e-20f, 1e-12f, 1e-7f, 1e-4f, 1e4f, 1e7f, 1e10f, 1e15f}) {
            SCOPED_TRACE(testing::Message() << int(weight) << ' ' << scale);
            options.weight = weight;
            Shape s = displaced(make_sphere(20, 10), 3);
            for (vec3& p : s.positions) p = p * scale;
            expect_as_general(cut_at_random(s, 2, 3), options, 1e-5);
        }
}

TEST(FastPath, SeamsAreBitEqual) {
    const auto parts = cut_at_random(displaced(make_torus(90, 60), 1), 16, 5);
    const auto out = compute(parts, published());
    std::map<std::tuple<float, float, float>, vec3> normal_at;
    std::size_t shared = 0;
    for (std::size_t m = 0; m < parts.size(); ++m)
        for (std::size_t v = 0; v < parts[m].positions.size(); ++v) {
            const vec3 p = parts[m].positions[v];
            const auto [at, is_new] = normal_at.try_emplace({p.x, p.y, p.z}, out[m].normals[v]);
            EXPECT_EQ(at->second, out[m].normals[v]);
            shared += is_new ? 0 : 1;
        }
    EXPECT_GT(shared, 5000u);
}

TEST(FastPath, HasTheSameBitsForAllThreadsAndInstructionSets) {
    std::vector<Shape> parts =
        cut_by_planes(displaced(make_torus(900, 400), 3), 3);  // 720 000 triangles: several pieces each
    const auto more = random_model(7, 6, 3000);
    parts.insert(parts.end(), more.begin(), more.end());
    for (const bool creased : {false, true})
        for (const bool tangents : {false, true}) {
            AttributeOptions options = published();
            options.tangents = tangents;
            if (creased) options.weight = CornerWeight::automatic, options.crease_angle_rad = radians(60);
            const auto expected = compute(parts, options, 1);
            for (const int threads : {2, 4}) expect_equal(expected, compute(parts, options, threads));
            for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512}) {
                if (!is_available(isa)) continue;
                const IsaGuard guard(name(isa));
                expect_equal(expected, compute(parts, options, 2));
            }
        }
}

TEST(FastPath, TakesShuffledMeshesOfManyPieces) {
    Shape s = displaced(make_torus(700, 300), 9);
    std::mt19937 random(3);
    std::vector<std::uint32_t> order(s.positions.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    Shape mixed = s;
    for (std::uint32_t v = 0; v < order.size(); ++v) {
        mixed.positions[order[v]] = s.positions[v];
        mixed.texcoords[order[v]] = s.texcoords[v];
    }
    for (std::uint32_t& i : mixed.indices) i = order[i];
    for (std::size_t t = mixed.indices.size() / 3; t-- > 1;)
        std::swap_ranges(&mixed.indices[3 * t], &mixed.indices[3 * t] + 3, &mixed.indices[3 * (random() % t)]);
    expect_as_general({mixed}, published());
    AttributeOptions creased = published();
    creased.weight = CornerWeight::angle, creased.crease_angle_rad = radians(60);
    expect_as_general({mixed}, creased);
}

TEST(FastPath, HardNumbersComeOutAsFromTheGeneralPath) {
    Shape tiny = make_sphere(20, 10), huge = tiny, far = tiny, broken = tiny;
    for (vec3& p : tiny.positions) p = p * 1e-20f;
    for (vec3& p : huge.positions) p = p * 1e15f;
    for (vec3& p : far.positions) p = p + vec3{1000, 0, 0};
    broken.positions[37].y = std::numeric_limits<float>::quiet_NaN();
    broken.positions[70].x = std::numeric_limits<float>::infinity();
    broken.indices[8] = broken.indices[6];
    for (Shape s : {tiny, huge, far, broken}) {
        expect_as_general({s}, published());
        for (vec2& uv : s.texcoords) uv = uv * 1e-18f;
        expect_as_general({s}, published());
        for (vec2& uv : s.texcoords) uv = {0.5f, 0.5f};
        expect_as_general({s}, published());
        s.texcoords[40].x = std::numeric_limits<float>::quiet_NaN();
        expect_as_general({s}, published());
    }
}

TEST(FastPath, OppositeShellsKeepTheirSides) {
    Shape outside = displaced(make_sphere(24, 12), 1), inside = outside;
    for (std::size_t i = 0; i < inside.indices.size(); i += 3) std::swap(inside.indices[i], inside.indices[i + 1]);
    inside.object = 1;
    expect_as_general({outside, inside}, published());
    const auto out = compute({outside, inside}, published());
    for (std::size_t v = 30; v < 200; ++v) EXPECT_LT(dot(out[0].normals[v], out[1].normals[v]), -0.99f);
}

TEST(FastPath, MirroredTextureSplitsVertices) {
    Shape s = displaced(make_torus(40, 20), 2);
    for (vec2& uv : s.texcoords) uv.x = uv.x < 0.5f ? uv.x : 1 - uv.x;
    expect_as_general({s}, published());
    EXPECT_FALSE(compute({s}, published())[0].source_vertex.empty());
    auto parts = cut_at_random(s, 5, 1);
    for (Shape& p : parts) p.object = 0;
    expect_as_general(parts, published());
}

TEST(FastPath, MatricesThatKeepAnglesAreTaken) {
    dmat4 m;
    m[0] = {0, 2.5, 0, 0};
    m[1] = {0, 0, -2.5, 0};
    m[2] = {2.5, 0, 0, 0};  // mirrors
    m[3] = {1e6, -3, 0.1, 1};
    auto parts = cut_by_planes(displaced(make_sphere(40, 20), 4), 3);
    for (Shape& p : parts) p.to_world = m;
    expect_as_general(parts, published());
    for (const CornerWeight weight : {CornerWeight::angle, CornerWeight::max, CornerWeight::automatic}) {
        AttributeOptions options = published();
        options.weight = weight, options.crease_angle_rad = radians(40);
        expect_as_general(parts, options, 3e-5);
    }
    parts[1].to_world[3].x += 1;
    EXPECT_FALSE(geometry::takes_fast_path(views(parts), published()));
    for (Shape& p : parts) p.to_world[0] = {0, 2.4, 0, 0};
    EXPECT_FALSE(geometry::takes_fast_path(views(parts), published()));
}

TEST(FastPath, EmptyAndSmallInputIsTaken) {
    Shape empty, lonely, one;
    lonely.positions = {{1, 2, 3}};
    one.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    one.indices = {0, 1, 2};
    expect_as_general({empty}, published());
    expect_as_general({lonely, empty, one, lonely}, published());
    EXPECT_EQ(compute({lonely}, published())[0].isolated_vertices, 1u);
    one.indices = {0, 1, 3};
    EXPECT_THROW(compute({one}, published()), Error);
    empty.indices = {0, 0, 0};
    EXPECT_THROW(compute({empty}, published()), Error);
}

TEST(AttributeBuffers, HoldWhatTheArraysHold) {
    for (const double crease : {180.0, 40.0}) {
        Shape s = displaced(make_torus(40, 20), 2);
        for (vec2& uv : s.texcoords) uv.x = uv.x < 0.5f ? uv.x : 1 - uv.x;
        auto parts = cut_at_random(s, 3, 1);
        parts.push_back(make_cube());
        AttributeOptions options = published();
        options.crease_angle_rad = radians(crease);
        const auto expected = compute(parts, options);
        Context context({.threads = 2});
        AttributeWorkspace workspace;
        std::vector<std::vector<vec3>> normals;
        std::vector<std::vector<vec4>> tangents;
        std::vector<AttributeBuffers> out;
        for (const Shape& p : parts) {
            normals.emplace_back(p.positions.size() + 1, vec3{7, 7, 7});
            tangents.emplace_back(p.texcoords.size() + 1, vec4{7, 7, 7, 7});
        }
        for (std::size_t m = 0; m < parts.size(); ++m) out.push_back({normals[m], tangents[m]});
        const auto splits = compute_attributes_into(views(parts), options, out, workspace, context);
        for (std::size_t m = 0; m < parts.size(); ++m) {
            EXPECT_EQ(normals[m].back(), (vec3{7, 7, 7}));
            EXPECT_EQ(tangents[m].back(), (vec4{7, 7, 7, 7}));
            normals[m].pop_back();
            tangents[m].pop_back();
            normals[m].insert(normals[m].end(), splits[m].normals.begin(), splits[m].normals.end());
            tangents[m].insert(tangents[m].end(), splits[m].tangents.begin(), splits[m].tangents.end());
            auto indices = parts[m].indices;
            for (const CornerVertex& c : splits[m].corners) indices[c.corner] = c.vertex;
            EXPECT_EQ(normals[m], expected[m].normals);
            EXPECT_EQ(tangents[m], expected[m].tangents);
            EXPECT_EQ(indices, expected[m].indices.empty() ? parts[m].indices : expected[m].indices);
            EXPECT_EQ(splits[m].source_vertex, expected[m].source_vertex);
        }
    }
}

TEST(AttributeBuffers, AWorkspaceServesModelsOfOtherSizes) {
    Context context({.threads = 2});
    AttributeWorkspace workspace;
    for (const std::uint32_t columns : {10u, 300u, 6u, 500u, 20u}) {
        for (const bool tangents : {true, false}) {
            const auto parts = cut_by_planes(displaced(make_torus(columns, columns), 1), 4);
            AttributeOptions options = published();
            options.tangents = tangents;
            const auto expected = compute(parts, options);
            std::vector<std::vector<vec3>> normals;
            std::vector<std::vector<vec4>> tangent_arrays;
            std::vector<AttributeBuffers> out;
            for (const Shape& p : parts) {
                normals.emplace_back(p.positions.size());
                tangent_arrays.emplace_back(tangents ? p.positions.size() : 0);
            }
            for (std::size_t m = 0; m < parts.size(); ++m) out.push_back({normals[m], tangent_arrays[m]});
            const auto splits = compute_attributes_into(views(parts), options, out, workspace, context);
            for (std::size_t m = 0; m < parts.size(); ++m) {
                EXPECT_TRUE(splits[m].source_vertex.empty());
                EXPECT_EQ(normals[m], expected[m].normals);
                EXPECT_EQ(tangent_arrays[m], expected[m].tangents);
            }
        }
    }
    EXPECT_GT(workspace.bytes(), 500u * 500u * 40u);
    const AttributeWorkspace taken = std::move(workspace);
    EXPECT_EQ(workspace.bytes(), 0u);  // NOLINT(bugprone-use-after-move)
    const auto parts = cut_by_planes(make_torus(10, 10), 4);
    std::vector<std::vector<vec3>> normals;
    std::vector<AttributeBuffers> out;
    for (const Shape& p : parts) normals.emplace_back(p.positions.size());
    for (auto& n : normals) out.push_back({n, {}});
    AttributeOptions options = published();
    options.tangents = false;
    compute_attributes_into(views(parts), options, out, workspace, context);  // serves as a new one
    EXPECT_EQ(normals[0], compute(parts, options)[0].normals);
}

TEST(AttributeBuffers, TooSmallOnesAreRefused) {
    Context context({.threads = 1});
    AttributeWorkspace workspace;
    const std::vector<Shape> shapes{make_sphere(8, 4)};
    const std::size_t count = shapes[0].positions.size();
    std::vector<vec3> normals(count);
    std::vector<vec4> tangents(count);
    const auto into = [&](std::size_t n, std::size_t t, const AttributeOptions& options) {
        const std::vector<AttributeBuffers> out{{std::span(normals).first(n), std::span(tangents).first(t)}};
        compute_attributes_into(views(shapes), options, out, workspace, context);
    };
    for (const AttributeOptions& options : {published(), AttributeOptions{}}) {
        EXPECT_THROW(into(count - 1, count, options), Error);
        EXPECT_THROW(into(count, count - 1, options), Error);
        EXPECT_NO_THROW(into(count, count, options));
        AttributeOptions no_tangents = options;
        no_tangents.tangents = false;
        EXPECT_NO_THROW(into(count, 0, no_tangents));
    }
    EXPECT_THROW(compute_attributes_into(views(shapes), published(), {}, workspace, context), Error);
}

}  // namespace
}  // namespace rakelight::test
