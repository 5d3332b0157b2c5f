// SPDX-License-Identifier: Apache-2.0
// Loops over all triangles that are not parallel look whether the run is cancelled, each by itself.
#include <gtest/gtest.h>

#include "geometry/faults/edge_census.h"
#include "geometry/faults/inside_out.h"
#include "geometry/faults/mesh_faults.h"
#include "geometry/faults/normal_sides.h"
#include "geometry/faults/t_junctions.h"
#include "support/thrown_error.h"
#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

TEST(CancelledLooks, AtSurfacesEnd) {
    const std::vector<Shape> shapes{make_torus(100, 100)};  // 20,000 triangles: more than one CancelCheck lets pass
    const std::vector<AttributeMesh> meshes = views(shapes);
    Context context, cancelled;
    cancelled.cancel();
    const geometry::PlacedMeshes placed = geometry::place_vertices(meshes, -1, context);
    const std::vector<std::uint32_t> open{0, 1, 2};
    const auto reason = [](const auto& look) { return error_of(look).reason(); };
    EXPECT_EQ(reason([&] { geometry::count_edges(placed, 1, cancelled); }), "cancelled");
    EXPECT_EQ(reason([&] { geometry::count_faults(placed, 1, cancelled); }), "cancelled");
    EXPECT_EQ(reason([&] { geometry::find_t_junctions(placed, open, 1, 10, cancelled); }), "cancelled");
    EXPECT_EQ(reason([&] { geometry::find_inside_out(placed, open, cancelled); }), "cancelled");
}

}  // namespace
}  // namespace rakelight::test
