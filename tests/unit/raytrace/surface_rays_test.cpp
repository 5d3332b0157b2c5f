// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/surface_rays.h"

#include <gtest/gtest.h>

#include "math/linear.h"
#include "support/scene_builder.h"

namespace rakelight::raytrace {
namespace {

using namespace test;

class SurfaceRaysTest : public testing::Test {
protected:
    /// A square in z = 0, and a mirrored one, twice as large, in z = 3; far from the world's origin.
    static Scene two_squares() {
        Scene scene;
        add_object(scene, square_mesh(), translation(away));
        add_object(scene, square_mesh(), translation(away + dvec3{0, 0, 3}) * scaling(dvec3{-2, 2, 1}));
        return scene;
    }
    static constexpr dvec3 away{1e4, -2e4, 3e4};
    Context context_{{.threads = 1}};
};

TEST_F(SurfaceRaysTest, HitsHaveWeightsThatGiveThePlace) {
    const SurfaceRays rays(two_squares(), context_);
    for (const dvec2 at : {dvec2{0.3, 0.4}, dvec2{-0.9, 0.1}, dvec2{0.25, -0.75}}) {
        const dvec3 from = away + dvec3{at.x, at.y, 2}, down{0, 0, -0.5};
        const auto hit = rays.first(from, down, 0, 100);
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->draw, 0u);
        EXPECT_NEAR(hit->t, 4, 1e-9);  // in lengths of the direction
        const shading::Draw& draw = rays.list().draws[hit->draw];
        const Mesh& mesh = rays.list().scene.meshes[draw.mesh];
        dvec3 place{};
        for (std::size_t k = 0; k < 3; ++k)
            place = place +
                    transform_point(draw.to_world, cast<double>(mesh.positions[mesh.indices[3 * hit->triangle + k]])) *
                        hit->weight[k];
        EXPECT_LT(length(place - (from + down * hit->t)), 1e-9);
        EXPECT_NEAR(hit->weight[0] + hit->weight[1] + hit->weight[2], 1, 1e-12);
    }
}

TEST_F(SurfaceRaysTest, FirstIsTheNearestBetweenItsEnds) {
    const SurfaceRays rays(two_squares(), context_);
    const dvec3 from = away + dvec3{0.1, 0.2, 5}, down{0, 0, -1};
    EXPECT_EQ(rays.first(from, down, 0, 100)->draw, 1u);
    EXPECT_EQ(rays.first(from, down, 2.5, 100)->draw, 0u);
    EXPECT_FALSE(rays.first(from, down, 2.5, 4));
    EXPECT_FALSE(rays.first(from, dvec3{0, 0, 1}, 0, 100));
    EXPECT_EQ(rays.first(away + dvec3{1.5, 0, -5}, dvec3{0, 0, 1}, 0, 100)->draw,
              1u);  // beside the small one, from behind
}

TEST_F(SurfaceRaysTest, WhatStandsBetweenTwoPlacesBlocks) {
    const SurfaceRays rays(two_squares(), context_);
    EXPECT_TRUE(rays.is_blocked(away + dvec3{0, 0, 1}, away + dvec3{0, 0, -1}));
    EXPECT_FALSE(rays.is_blocked(away + dvec3{0, 0, 1}, away + dvec3{0, 0, 2}));
    EXPECT_FALSE(rays.is_blocked(away + dvec3{0.2, 0.1, 0}, away + dvec3{0.2, 0.1, 3}));  // its ends do not count
    EXPECT_FALSE(rays.is_blocked(away + dvec3{1.5, 0, 1}, away + dvec3{1.5, 0, -1}));
}

}  // namespace
}  // namespace rakelight::raytrace
