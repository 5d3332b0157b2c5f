// SPDX-License-Identifier: Apache-2.0
// Meshes that share places, directly or by others, are one island.
#include <gtest/gtest.h>

#include "geometry/faults/mesh_islands.h"

namespace rakelight {
namespace {

TEST(MeshIslands, AreConnectedByCommonPlacesHoweverManyLieBetween) {
    const std::vector<std::uint32_t> indices{0, 1, 2};
    const auto at = [](float x) { return std::vector<vec3>{{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}}; };
    // 0 meets 4, which meets 2; 1 meets 3; 5 has no vertices; 6 stands alone.
    const std::vector<std::vector<vec3>> positions{at(0), at(10), at(2), at(11), at(1), {}, at(20)};
    std::vector<AttributeMesh> meshes(positions.size());
    for (std::uint32_t m = 0; m < meshes.size(); ++m) {
        meshes[m].object = m;
        meshes[m].positions = positions[m];
        if (!positions[m].empty()) meshes[m].indices = indices;
    }
    Context context;
    const AttributePlan plan = group(meshes, {.weld_distance = 0}, context);
    EXPECT_EQ(geometry::mesh_islands(plan), (std::vector<std::uint32_t>{0, 1, 0, 1, 0, 5, 6}));
    AttributeOptions apart;
    apart.scope = Scope::object;
    EXPECT_EQ(geometry::mesh_islands(group(meshes, apart, context)), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6}));
    EXPECT_TRUE(geometry::mesh_islands(group({}, {}, context)).empty());
}

}  // namespace
}  // namespace rakelight
