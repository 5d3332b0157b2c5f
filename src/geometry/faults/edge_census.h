// SPDX-License-Identifier: Apache-2.0
// Edges between places, with the number and orientation of their faces.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/faults/place_classes.h"

namespace rakelight::geometry {

/// Edge counts of one object.
struct ObjectEdges {
    std::uint64_t edges = 0;
    std::uint64_t open = 0;          ///< with one face
    std::uint64_t inconsistent = 0;  ///< with two faces of opposite orientation: one of them is inside out
    std::uint64_t non_manifold = 0;  ///< with three or more faces
    bool is_closed() const { return edges > 0 && open == 0; }
};

/// An edge from place a to place b, a < b.
struct PlaceEdge {
    std::uint32_t a, b;
    bool operator==(const PlaceEdge&) const = default;
};

/// Edges of two objects with one face each, of opposite orientation.
struct InconsistentBorder {
    std::uint32_t object_a, object_b;  ///< a < b
    std::uint64_t edges;
};

struct EdgeCensus {
    std::vector<ObjectEdges> objects;
    std::vector<InconsistentBorder> inconsistent_borders;  ///< each pair once, ascending
    std::vector<std::uint32_t> open_corners;  ///< edges of one face in the whole model: the corner where each begins
    std::vector<PlaceEdge> border_edges;      ///< of faces of two or more meshes
};

/// Orientation is evaluated in world space: mirroring matrices reverse it. Faces with a non-finite corner, or with two
/// corners at one place, are skipped. Lists are in the order of the edges' smaller place. Expected O(n), 8 bytes per
/// corner. `objects` is larger than every AttributeMesh::object.
EdgeCensus count_edges(const PlacedMeshes& placed, std::uint32_t objects, const Context& context);

}  // namespace rakelight::geometry
