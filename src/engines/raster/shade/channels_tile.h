// SPDX-License-Identifier: Apache-2.0
// Data channels beyond depth, normal, object and material, which visibility and shading already compute.
#pragma once
#include "engines/raster/tile.h"

namespace rakelight::raster {

inline constexpr std::uint32_t further_channels =
    channels_all & ~std::uint32_t(channel_depth | channel_normal | channel_object | channel_material);

/// Memory for the requested ones, filled with their background values.
void clear_channels(std::uint32_t channels, TileScratch& scratch);
/// Those of a batch whose records are made: `wanted` and the batch arrays are as shading has left them.
void fill_channels(const TileJob& job, const ShadeJob& batch, std::uint32_t draw, TileScratch& scratch);
/// Opaque surfaces over each pixel of a tile. Writes over the batch arrays.
void count_overdraw(const TileJob& job, std::size_t tile, TileScratch& scratch);

}  // namespace rakelight::raster
