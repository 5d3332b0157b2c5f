// SPDX-License-Identifier: Apache-2.0
// Blended surfaces of a tile over its colors, and in multisampled pictures over those of its samples.
#pragma once
#include "engines/raster/tile.h"

namespace rakelight::raster {

class MarkLayers;

/// The blended triangles of a tile, into Binned::items, far to near by the middle of each: the order in which they are
/// shaded, and that in which methods without depth lay them.
std::vector<std::uint32_t> blending_order(const TileJob& job, std::size_t tile);

/// Triangles are shaded in batches: those of a draw that follow one another in the order.
/// @param order  blending_order(): far to near, triangle by triangle. Methods without depth keep it at every pixel.
/// @param samples  1: over TileScratch::color, else over the samples' colors
/// @param marks  lines and points between the surfaces; null: there are none
void lay_blended(const TileJob& job, std::size_t tile, const std::vector<std::uint32_t>& order, MarkLayers* marks,
                 int samples, TileScratch& scratch);

/// Blended surfaces over the opaque ones, far to near at each pixel, then lines and points.
void blend_transparent(const TileJob& job, std::size_t tile, TileScratch& scratch);

}  // namespace rakelight::raster
