// SPDX-License-Identifier: Apache-2.0
#include "geometry/faults/mesh_faults.h"

#include <gtest/gtest.h>

#include <limits>

#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

using geometry::ObjectFaults;

std::vector<ObjectFaults> faults_of(const std::vector<Shape>& shapes) {
    Context context;
    const std::vector<AttributeMesh> meshes = views(shapes);
    return count_faults(geometry::place_vertices(meshes, -1, context), std::uint32_t(shapes.size()), context);
}

/// Four quads in a row with u running up, up, down, down: a mirrored chart.
Shape mirrored_strip() {
    Shape s = make_grid(4, 1, [](double u, double v) { return vec3{float(4 * u), float(v), 0}; });
    for (vec2& uv : s.texcoords) uv.x = uv.x > 0.5f ? 1 - uv.x : uv.x;
    return s;
}

TEST(MeshFaults, AnOrdinaryMeshHasNone) {
    Shape grid = make_grid(3, 3, [](double u, double v) { return vec3{float(u), float(v), 0}; });
    grid.normals.assign(grid.positions.size(), {0, 0, 1});
    const ObjectFaults f = faults_of({grid})[0];
    EXPECT_EQ(f.zero_normals + f.non_finite_normals + f.non_unit_normals + f.degenerate_faces, 0u);
    EXPECT_EQ(f.mirrored_places + f.mirror_split_vertices, 0u);
}

TEST(MeshFaults, NormalsAreToldApartByWhatIsWrongWithThem) {
    Shape s = make_grid(2, 1, [](double u, double v) { return vec3{float(u), float(v), 0}; });
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    s.normals = {{0, 0, 0}, {nan, 0, 0}, {0, inf, 0}, {0, 0, 2}, {0, 0, 1.005f}, {0, 0, 1}};
    s.positions.push_back({9, 9, 9});  // no face uses it
    s.texcoords.push_back({});
    s.normals.push_back({0, 0, 0});
    const ObjectFaults f = faults_of({s})[0];
    EXPECT_EQ(f.zero_normals, 1u);
    EXPECT_EQ(f.non_finite_normals, 2u);
    EXPECT_EQ(f.non_unit_normals, 1u);
    s.normals.clear();
    EXPECT_EQ(faults_of({s})[0].zero_normals, 0u);  // without normals there is nothing to say
}

TEST(MeshFaults, FacesWithoutAreaOrWithBadCornersAreDegenerate) {
    Shape s;
    s.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {NAN, 0, 0}, {0, 0, 0}};
    s.indices = {0, 1, 3, 0, 1, 2, 0, 0, 3, 0, 5, 3, 0, 1, 4};
    EXPECT_EQ(faults_of({s})[0].degenerate_faces, 4u);
    s.to_world = scaling(dvec3{1, 0, 1});  // flattened in the world
    EXPECT_EQ(faults_of({s})[0].degenerate_faces, 5u);
}

TEST(MeshFaults, MirroredChartsAreCountedWhereTheyMeet) {
    const ObjectFaults f = faults_of({mirrored_strip()})[0];
    EXPECT_EQ(f.mirrored_places, 2u);
    EXPECT_EQ(f.mirror_split_vertices, 2u);
    Shape apart = mirrored_strip();  // both sides with vertices of their own: they meet, nothing needs splitting
    for (std::size_t i = 12; i < apart.indices.size(); ++i)
        if (apart.positions[apart.indices[i]].x == 2) {
            apart.positions.push_back(apart.positions[apart.indices[i]]);
            apart.texcoords.push_back(apart.texcoords[apart.indices[i]]);
            apart.indices[i] = std::uint32_t(apart.positions.size() - 1);
        }
    const ObjectFaults g = faults_of({apart})[0];
    EXPECT_EQ(g.mirrored_places, 2u);
    EXPECT_EQ(g.mirror_split_vertices, 0u);
}

TEST(MeshFaults, ObjectsAtOnePlaceDoNotMixAndMeshesOfOneObjectDo) {
    std::vector<Shape> parts = cut(mirrored_strip(), 2, [](std::size_t t) { return t < 4 ? 0u : 1u; });
    EXPECT_EQ(faults_of(parts)[0].mirrored_places + faults_of(parts)[1].mirrored_places, 0u);
    parts[1].object = 0;
    EXPECT_EQ(faults_of(parts)[0].mirrored_places, 2u);
}

}  // namespace
}  // namespace rakelight::test
