// SPDX-License-Identifier: Apache-2.0
// What rays meet, against every triangle looked at one by one.
#include "engines/raytrace/scene/ray_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <rakelight/world/load.h>

#include "cpu_shading/draw_list.h"
#include "math/linear.h"
#include "support/scene_builder.h"

namespace rakelight::raytrace {
namespace {

struct Loaded {
    shading::TextureCache textures;
    cpu_shading::DrawList list;
    RayScene rays{best_isa()};

    explicit Loaded(Scene scene, Context& context)
        : list(cpu_shading::make_draw_list(std::move(scene), textures, context)) {
        rays.set(list, context);
    }
};

class Rays : public testing::Test {
protected:
    dvec3 direction() {
        std::normal_distribution<double> normal;
        return normalize_or(dvec3{normal(random_), normal(random_), normal(random_)}, dvec3{0, 0, 1});
    }
    double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

    /// Triangles of all sizes in a box of side 2, some of them turned over.
    Scene soup(std::size_t triangles) {
        Scene scene;
        Mesh mesh;
        std::vector<vec3> positions;
        std::vector<std::uint32_t> indices;
        for (std::size_t t = 0; t < triangles; ++t) {
            const dvec3 middle{number(-1, 1), number(-1, 1), number(-1, 1)};
            const double size = std::exp(number(-6, -1));
            for (int k = 0; k < 3; ++k) {
                indices.push_back(std::uint32_t(positions.size()));
                positions.push_back(cast<float>(middle + direction() * size));
            }
        }
        mesh.positions = std::move(positions), mesh.indices = std::move(indices);
        test::add_object(scene, std::move(mesh));
        return scene;
    }

    std::mt19937 random_{7};
    Context context_;
};

/// The nearest of all, in double; `margin`: how near to an edge the ray passes it, 0..1/3 in weights of the corners.
struct Nearest {
    double t = INFINITY, margin = 0;
    std::uint32_t triangle = no_index;
};

Nearest nearest(const Mesh& mesh, dvec3 origin, dvec3 along) {
    Nearest out;
    for (std::uint32_t t = 0; t < mesh.indices.size() / 3; ++t) {
        dvec3 p[3];
        for (std::size_t k = 0; k < 3; ++k) p[k] = cast<double>(mesh.positions[mesh.indices[3 * t + k]]);
        const dvec3 a = p[1] - p[0], b = p[2] - p[0], h = cross(along, b);
        const double det = dot(a, h);
        if (det == 0) continue;
        const dvec3 s = origin - p[0], q = cross(s, a);
        const double u = dot(s, h) / det, v = dot(along, q) / det, at = dot(b, q) / det;
        if (u < 0 || v < 0 || u + v > 1 || at <= 0 || at >= out.t) continue;
        out = {at, std::min({u, v, 1 - u - v}), t};
    }
    return out;
}

TEST_F(Rays, MeetWhatBruteForceFinds) {
    const Scene scene = soup(500);
    const Loaded loaded(scene, context_);
    int met = 0, compared = 0;
    for (int i = 0; i < 20000; ++i) {
        const dvec3 origin{number(-2, 2), number(-2, 2), number(-2, 2)}, along = direction();
        const Nearest exact = nearest(scene.meshes[0], origin, along);
        const Meeting m =
            loaded.rays.first(cast<float>(origin - loaded.rays.origin()), cast<float>(along), 0, 1e9f, nullptr);
        const bool is_blocked =
            loaded.rays.is_blocked(cast<float>(origin - loaded.rays.origin()), cast<float>(along), 0, 1e9f, nullptr);
        EXPECT_EQ(is_blocked, m.draw != no_index);
        met += m.draw != no_index;
        if (exact.triangle == no_index || exact.margin < 1e-3) continue;  // at an edge rounding decides
        ++compared;
        if (m.triangle != exact.triangle)  // in front of it another one may lie whose edge is near
            EXPECT_LE(double(m.t), exact.t * (1 + 1e-5)) << i;
        else
            EXPECT_NEAR(double(m.t), exact.t, 1e-4) << i;
    }
    EXPECT_GT(compared, 1000);
    EXPECT_GT(met, compared);
}

TEST_F(Rays, PassNoSeamOfASphereCutIntoObjects) {
    Scene scene = load("builtin:sphere:tolerance=0.0005:objects=7", {}, context_);
    const Loaded loaded(std::move(scene), context_);
    EXPECT_EQ(loaded.list.draws.size(), 7u);
    std::atomic<int> passed{0};
    context_.parallel_for(100, [&](std::size_t chunk) {
        std::mt19937_64 random(chunk);
        std::normal_distribution normal;
        std::uniform_real_distribution share(0.0, 0.9);
        const auto any = [&] {
            return normalize_or(dvec3{normal(random), normal(random), normal(random)}, dvec3{1, 0, 0});
        };
        for (int i = 0; i < 100000; ++i) {
            const vec3 origin = cast<float>(any() * share(random) - loaded.rays.origin());
            passed += !loaded.rays.is_blocked(origin, cast<float>(any()), 0, 10, nullptr);
        }
    });
    EXPECT_EQ(passed, 0) << "of 10 million";
}

/// Notes which side it is shown.
class Sides final : public RayFilter {
public:
    bool counts(const Meeting& m) const override {
        seen.push_back({m.draw, m.is_against});
        return m.draw != refused;
    }
    std::uint32_t refused = no_index;
    mutable std::vector<std::pair<std::uint32_t, bool>> seen;
};

TEST_F(Rays, FiltersSeeTheSideInTheWorld) {
    Scene scene;
    test::add_object(scene, test::square_mesh(), translation(dvec3{0, 0, 1}));
    dmat4 mirrored;
    mirrored[0] = {-1, 0, 0, 0};  // the order of the corners turns
    test::add_object(scene, test::square_mesh(), mirrored);
    const Loaded loaded(scene, context_);
    Sides sides;
    sides.refused = 0;
    const vec3 from = cast<float>(dvec3{0.2, 0.1, 5} - loaded.rays.origin());
    const Meeting m = loaded.rays.first(from, {0, 0, -1}, 0, 100, &sides);
    EXPECT_EQ(m.draw, 1u);
    EXPECT_FLOAT_EQ(m.t, 5);
    ASSERT_EQ(sides.seen.size(), 2u);
    for (const auto& [draw, is_against] : sides.seen) EXPECT_EQ(is_against, draw == 0) << draw;
    sides.seen.clear(), sides.refused = no_index;
    const vec3 behind = cast<float>(dvec3{0.2, 0.1, -5} - loaded.rays.origin());
    EXPECT_EQ(loaded.rays.first(behind, {0, 0, 1}, 0, 100, &sides).draw, 1u);
    EXPECT_TRUE(sides.seen.back().second);
}

/// A large mesh at two places, with a scene of its own, among small ones that lie together.
TEST_F(Rays, MeetSmallAndLargeMeshesByTheirOwnNumbers) {
    Scene scene;
    for (int i = 0; i < 5; ++i) test::add_object(scene, test::square_mesh(), translation(dvec3{3.0 * i, 0, 0}));
    Mesh large = load("builtin:sphere:tolerance=0.0002", {}, context_).meshes[0];
    ASSERT_GT(large.triangle_count(), 4096u);
    large.shape.reset();
    const std::uint32_t node = test::add_object(scene, std::move(large), translation(dvec3{0, 5, 0}));
    scene.nodes.push_back(scene.nodes[node]);
    scene.nodes.back().local.matrix = translation(dvec3{6, 5, 0});
    const Loaded loaded(scene, context_);
    ASSERT_EQ(loaded.list.draws.size(), 7u);
    const auto met_at = [&](double x, double y) {
        return loaded.rays.first(cast<float>(dvec3{x, y, 10} - loaded.rays.origin()), {0, 0, -1}, 0, 100, nullptr);
    };
    for (std::uint32_t i = 0; i < 5; ++i) {
        const Meeting upper = met_at(3.0 * i - 0.3, 0.6), lower = met_at(3.0 * i + 0.3, -0.6);
        EXPECT_EQ(upper.draw, i);
        EXPECT_EQ(lower.draw, i);
        EXPECT_EQ(upper.triangle, 1u);
        EXPECT_EQ(lower.triangle, 0u);
        EXPECT_FLOAT_EQ(lower.t, 10);
    }
    EXPECT_EQ(met_at(0, 5).draw, 5u);
    EXPECT_EQ(met_at(6, 5).draw, 6u);
    EXPECT_NEAR(met_at(6, 5).t, 9, 1e-3);
    EXPECT_EQ(met_at(1.5, 0).draw, no_index);
}

TEST_F(Rays, AnEmptySceneIsMetNowhere) {
    const Loaded loaded(Scene{}, context_);
    EXPECT_EQ(loaded.rays.first({0, 0, 0}, {0, 0, 1}, 0, 10, nullptr).draw, no_index);
}

TEST_F(Rays, ACancelledBuildIsAnError) {
    const Scene scene = soup(1000);
    shading::TextureCache textures;
    const cpu_shading::DrawList list = cpu_shading::make_draw_list(scene, textures, context_);
    RayScene rays(best_isa());
    Context cancelled;
    cancelled.cancel();
    EXPECT_THROW(rays.set(list, cancelled), Error);
    EXPECT_EQ(rays.first({0, 0, 0}, {0, 0, 1}, 0, 10, nullptr).draw, no_index);
}

}  // namespace
}  // namespace rakelight::raytrace
