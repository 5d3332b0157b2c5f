// SPDX-License-Identifier: Apache-2.0
// Which planes are meant, and which are there by chance: squares of a scan, pairs among single triangles.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/creases/bent_edges.h"

namespace rakelight::geometry {

constexpr std::uint32_t small_surface = 64;  ///< faces

/// Planes and surfaces stand at their smallest face.
struct MeantPlanes {
    std::vector<std::uint32_t> faces_of_surface;  ///< [T]
    std::vector<std::uint8_t> has_planes;         ///< [T] of surfaces; without planes they count as single triangles
    std::vector<std::uint8_t> is_meant;           ///< [T] of planes: of two faces at least, and not by chance
};

/// A surface has planes, unless
/// - they are less than a tenth of its area, or
/// - rounding may turn the faces of three quarters of its area so far that nothing is known of their planes, or
/// - they are there by chance. Rounding turns most faces by less than a third of what it may turn at most. A shape that
///   was rounded, as a scan, does not stop there. More of its edges bend by a third to twice of it than by less, and
///   for more than a third of its faces this is the least bend. A fine shape of true planes may have the first, not the
///   second.
/// A pair of triangles is there by chance if it meets more single triangles than planes, up to the bends of `hard_deg`:
/// surfaces cut out of tetrahedra consist of such. In a small surface, as a roof, it must meet no plane at all.
MeantPlanes find_meant_planes(const BentEdges& bent, double hard_deg);

}  // namespace rakelight::geometry
