// SPDX-License-Identifier: Apache-2.0
// T-junctions: a vertex of an open border in the interior of an open edge of another face. Such borders show cracks,
// and welding does not join their faces.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/faults/place_classes.h"

namespace rakelight::geometry {

struct TJunction {
    std::uint32_t place;   ///< the vertex
    std::uint32_t corner;  ///< where the edge begins; the first such edge
};

struct TJunctions {
    std::uint64_t count = 0;                ///< places; each once
    std::vector<TJunction> places;          ///< the first of them, ascending
    std::vector<std::uint64_t> of_objects;  ///< [objects] by the object of the edge
    std::uint64_t edges_not_searched = 0;   ///< search cut off; only in hostile files
};

/// A place is on an edge when it is off by at most 1e-5 of the edge's length, or 4 float ulps of the open borders'
/// diagonal where that is more. It is also farther than that from the edge's ends. A k-d tree: unlike a grid it has no
/// cell size that fits neither the short nor the long edges. Expected O(n log n).
/// @param open_corners edges of one face only (EdgeCensus::open_corners); only their ends are examined
/// @param max_places maximum length of `places`
/// @param visits_per_edge bound of the work: average number of visited boxes, with an allowance for small models; real
/// models take up to 20
TJunctions find_t_junctions(const PlacedMeshes& placed, std::span<const std::uint32_t> open_corners,
                            std::uint32_t objects, std::size_t max_places, const Context& context,
                            std::uint64_t visits_per_edge = 64);

}  // namespace rakelight::geometry
