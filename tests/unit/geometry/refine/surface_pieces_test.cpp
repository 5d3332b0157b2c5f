// SPDX-License-Identifier: Apache-2.0
#include "geometry/refine/surface_pieces.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "geometry/refine/subdivide.h"
#include "math/linear.h"
#include "unit/geometry/refine/polygons.h"

namespace rakelight::geometry {
namespace {

using test::Faces, test::polygons;

const std::vector<dvec3> cube_places = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 1, 1},
                                        {1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1}};
const Faces cube_faces = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};

/// Edges between exact points that are used an odd number of times after three levels.
std::size_t open_edges(const Faces& faces, const std::vector<dvec3>& places, bool sharpens_corners = true) {
    Context context;
    const Polygons in = polygons(faces);
    const SurfacePieces pieces = part_surface(in, places, {.sharpens_corners = sharpens_corners});
    ControlSurface s{.level = 3, .faces = in, .pinned = pieces.pinned, .sharpens_corners = sharpens_corners};
    s.faces.corners = pieces.vertices;
    for (const std::uint32_t p : pieces.place_of) s.positions.push_back(places[p]);
    const LimitSurface out = subdivide(s, context);
    const auto key = [&](std::size_t corner) {
        const dvec3 p = out.positions[out.vertices[corner]];
        return std::array{std::llround(p.x * 1e9), std::llround(p.y * 1e9), std::llround(p.z * 1e9)};
    };
    std::map<std::set<std::array<long long, 3>>, int> uses;
    for (std::size_t i = 0; i < out.vertices.size(); ++i) ++uses[{key(i), key(i % 4 == 3 ? i - 3 : i + 1)}];
    std::size_t open = 0;
    for (const auto& [edge, count] : uses) open += std::size_t(count % 2);
    return open;
}

TEST(SurfacePieces, AClosedSurfaceIsOnePieceWithAVertexAtEachPlace) {
    const SurfacePieces pieces = part_surface(polygons(cube_faces), cube_places, {});
    EXPECT_EQ(pieces.place_of.size(), 8u);
    EXPECT_TRUE(pieces.pinned.empty());
    EXPECT_TRUE(pieces.creases.empty());
    EXPECT_EQ(pieces.parted_edges, 0u);
    EXPECT_EQ(open_edges(cube_faces, cube_places), 0u);
}

TEST(SurfacePieces, EdgesBentMoreThanTheAngleAreCreases) {
    EXPECT_EQ(part_surface(polygons(cube_faces), cube_places, {.crease_angle_rad = radians(89)}).creases.size(), 12u);
    EXPECT_EQ(part_surface(polygons(cube_faces), cube_places, {.crease_angle_rad = radians(91)}).creases.size(), 0u);
}

TEST(SurfacePieces, AFaceThatTurnsTheOtherWayIsAPieceOfItsOwnAndNothingOpens) {
    Faces faces = cube_faces;
    faces[0] = {2, 3, 1, 0};
    const SurfacePieces pieces = part_surface(polygons(faces), cube_places, {});
    EXPECT_EQ(pieces.parted_edges, 4u);
    EXPECT_EQ(pieces.place_of.size(), 12u);
    EXPECT_EQ(open_edges(faces, cube_places), 0u);
    EXPECT_EQ(open_edges(faces, cube_places, false), 0u);
}

TEST(SurfacePieces, ThreeFacesAtAnEdgeJoinTheTwoThatAreBentLeast) {
    std::vector<dvec3> places = cube_places;
    places.insert(places.end(), {{0, 0, 2}, {0, 1, 2}, {0, 0, -1}, {0, 1, -1}});
    Faces faces = {{0, 1, 3, 2}, {1, 8, 9, 3}, {1, 3, 7, 5}};  // a strip along z, and a fin at its edge 1-3
    const SurfacePieces pieces = part_surface(polygons(faces), places, {});
    EXPECT_EQ(pieces.parted_edges, 1u);
    EXPECT_EQ(pieces.vertices[1], pieces.vertices[4]);  // the strip goes on over the edge
    EXPECT_NE(pieces.vertices[1], pieces.vertices[8]);
    EXPECT_EQ(pieces.pinned.size(), 4u);  // the strip's and the fin's vertices at both ends of the edge
    // The strip's own boundary is all that is open, and the fin's without the edge where it stands
    EXPECT_EQ(open_edges(faces, places), (6u + 3u + 1u) * 8u);
}

TEST(SurfacePieces, TheTwoSidesOfALeafAreTwoSheetsThatMoveAlike) {
    Faces faces = {{0, 1, 3, 2}, {1, 5, 7, 3}};
    for (const auto& face : Faces(faces)) faces.push_back({face.rbegin(), face.rend()});
    const SurfacePieces pieces = part_surface(polygons(faces), cube_places, {});
    EXPECT_EQ(pieces.place_of.size(), 12u);
    EXPECT_TRUE(pieces.pinned.empty());
    EXPECT_EQ(open_edges(faces, cube_places), 0u);  // each edge has its twin on the other side
}

TEST(SurfacePieces, SolidsThatTouchInAPointAreHeldTogetherThere) {
    std::vector<dvec3> places = cube_places;
    Faces faces = cube_faces;
    for (std::uint32_t v = 1; v < 8; ++v) places.push_back(cube_places[v] + dvec3{1, 1, 1});
    for (auto face : cube_faces) {
        for (std::uint32_t& v : face) v = v == 0 ? 7 : 7 + v;  // its lowest corner is the first cube's highest
        faces.push_back(face);
    }
    const SurfacePieces pieces = part_surface(polygons(faces), places, {});
    EXPECT_EQ(pieces.place_of.size(), 16u);
    ASSERT_EQ(pieces.pinned.size(), 2u);
    EXPECT_EQ(pieces.place_of[pieces.pinned[0]], 7u);
    EXPECT_EQ(pieces.place_of[pieces.pinned[1]], 7u);
    EXPECT_EQ(open_edges(faces, places), 0u);
}

TEST(SurfacePieces, ManyFacesAtOneEdgeAreAllParted) {
    std::vector<dvec3> places = {{0, 0, 0}, {0, 0, 1}};
    Faces faces;
    for (std::uint32_t i = 0; i < 200; ++i) {
        places.push_back({double(i), 1, 0});
        if (i % 2)
            faces.push_back({0, 1, 2 + i});
        else
            faces.push_back({1, 0, 2 + i});
    }
    const SurfacePieces pieces = part_surface(polygons(faces), places, {});
    EXPECT_EQ(pieces.place_of.size(), 600u);
    EXPECT_EQ(pieces.parted_edges, 1u);
    EXPECT_EQ(open_edges(faces, places), 200u * 2 * 8);  // edge 0-1 is used 200 times
}

}  // namespace
}  // namespace rakelight::geometry
