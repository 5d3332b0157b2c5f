// SPDX-License-Identifier: Apache-2.0
// The edges of two faces over the places of all objects: how much each bends, how much of that may be rounding, and the
// planes between them.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/corners/topology.h"
#include "geometry/faults/place_classes.h"

namespace rakelight::geometry {

/// An edge of exactly two faces, or a pair of faces at an edge of more.
struct BentEdge {
    std::uint32_t corner[2];  ///< of both faces; the edge runs from it to the next corner of the face
    float bend_deg = 0;       ///< angle between the faces' normals; negative: concave
    float slack_deg = 0;      ///< the bend that is taken for a plane: rounding and a little more, limited
    float rounding_deg = 0;   ///< what rounding may bend, not limited
    bool is_crowded = false;  ///< more than two faces use the edge

    std::uint32_t face(int side) const { return corner[side] / 3; }
};

constexpr std::uint32_t no_edge = 0xffffffffu;

struct BentEdges {
    std::vector<BentEdge> edges;                ///< in the order of the places
    std::vector<std::uint32_t> edge_of_corner;  ///< [3T] of the edge from this corner to the next; or no_edge
    std::vector<std::uint8_t> crowded;          ///< [T] bit k: more than two faces use the edge from corner k
    std::vector<std::uint8_t> is_face;          ///< [T] whether the face takes part: valid, three different places
    std::vector<std::uint32_t> plane_of;        ///< [T] smallest face of its plane
    std::vector<std::uint32_t> surface_of;      ///< [T] smallest face of the surface: all that edges connect
    std::vector<float> area;                    ///< [T] [m^2]
    std::vector<std::uint8_t> is_mirrored;  ///< [T] its placement turns the order of its corners around; empty: none

    /// Whether its faces have their corners in opposite orders.
    bool is_turned(const BentEdge& e) const {
        return !is_mirrored.empty() && is_mirrored[e.face(0)] != is_mirrored[e.face(1)];
    }
    std::uint32_t plane(const BentEdge& e, int side) const { return plane_of[e.face(side)]; }
};

BentEdges find_bent_edges(const PlacedMeshes& placed, const FaceNormals& normals, Context& context);

/// The corners of a face in world space.
struct FacePoints {
    dvec3 p[3];
};
inline FacePoints face_points(const AttributeInput& input, std::uint32_t triangle) {
    const std::uint32_t m = input.mesh_of_triangle(triangle);
    const AttributeMesh& mesh = input.meshes[m];
    const std::uint32_t* const index = mesh.indices.data() + 3 * std::size_t(triangle - input.triangle_base[m]);
    FacePoints out;
    for (int k = 0; k < 3; ++k) out.p[k] = input.placements[m].position(mesh.positions[index[k]]);
    return out;
}

}  // namespace rakelight::geometry
