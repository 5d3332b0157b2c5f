// SPDX-License-Identifier: Apache-2.0
// Edges between places: how many faces each has, and which way round they use it.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/place_classes.h"

namespace rakelight::geometry {

/// The edges of one object, over its own faces.
struct ObjectEdges {
    std::uint64_t edges = 0;
    std::uint64_t open = 0;          ///< of one face
    std::uint64_t inconsistent = 0;  ///< of two faces that go along it the same way: one of them is wound inside out
    std::uint64_t non_manifold = 0;  ///< of three or more faces
    bool is_closed() const { return edges > 0 && open == 0; }
};

/// An edge from place a to place b, a < b.
struct PlaceEdge {
    std::uint32_t a, b;
    bool operator==(const PlaceEdge&) const = default;
};

/// Edges of two faces, one each of two objects, that go along it the same way.
struct InconsistentBorder {
    std::uint32_t object_a, object_b;  ///< a < b
    std::uint64_t edges;
};

struct EdgeCensus {
    std::vector<ObjectEdges> objects;
    std::vector<InconsistentBorder> inconsistent_borders;  ///< each pair once, ascending
    std::vector<std::uint32_t> open_corners;  ///< edges of one face in the whole model: the corner where each begins
    std::vector<PlaceEdge> border_edges;      ///< of faces of two or more objects
};

/// Which way a face goes along an edge is judged where it is placed: a matrix that mirrors turns it round. Faces with a
/// corner that is not finite or with two corners at one place are left out. Lists are in the order of the edges'
/// smaller place. Expected O(n), 8 bytes a corner; `objects` is more than the largest AttributeMesh::object.
EdgeCensus count_edges(const PlacedMeshes& placed, std::uint32_t objects, const Context& context);

}  // namespace rakelight::geometry
