// SPDX-License-Identifier: Apache-2.0
// Which blended triangles of a tile must be sorted pixel by pixel, and which are in order as they stand. Panes one behind
// another never cross in the tile, so each is laid at once; those that cross form a group of their own.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engines/raster/tile.h"

namespace rakelight::raster {

/// A triangle in the order in which those of a tile are shaded.
struct GroupedTriangle {
    std::uint32_t number;  ///< in the tile's list
    std::uint32_t group;   ///< all of a group are laid before those of the next one
    bool waits;            ///< others of the group are at some of its samples, and may be farther there
};

/// Far to near. Methods without depth keep their order, and nothing waits.
/// @param area      [px] part of the tile in which they are to be in order
/// @param order     blending_order(), or some of it
/// @param by_pixel  triangles that share a pixel and no sample have an order there, too
std::vector<GroupedTriangle> blend_groups(const TileJob& job, std::size_t tile, const Window& area,
                                          std::span<const std::uint32_t> order, bool by_pixel);

/// No sample is covered by both, because an edge of one lies between them.
bool lie_apart(const ScreenTriangle& a, const ScreenTriangle& b);

}  // namespace rakelight::raster
