// SPDX-License-Identifier: Apache-2.0
// What lies straight across the faces at an edge: where a plane has holes, or strips bend on, the width there says more
// than that of the whole plane.
#pragma once
#include "geometry/creases/bent_edges.h"

namespace rakelight::geometry {

/// The way over one side of an edge, to where its surface bends again.
struct Across {
    float width = 0;               ///< [m]
    std::uint32_t edge = no_edge;  ///< nearly parallel; no_edge: none, or the surface ends
    int beyond = 0;                ///< the side of `edge` that lies farther
};

constexpr int most_across = 256;  ///< triangles of a plane that are crossed; after more there is no way

/// Over the plane at one side, at right angles from the middle of the edge.
Across across_plane(const BentEdges& bent, const AttributeInput& input, std::uint32_t edge, int side);

/// Over the square of two single triangles at one side. The width is left 0.
/// @param flat_deg  the diagonal of a square bends less
/// @param is_after  the diagonal is the edge after the given one in its triangle, else the edge before it
Across across_square(const BentEdges& bent, std::uint32_t edge, int side, double flat_deg, bool is_after);

}  // namespace rakelight::geometry
