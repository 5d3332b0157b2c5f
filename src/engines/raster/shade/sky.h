// SPDX-License-Identifier: Apache-2.0
// The environment behind everything.
#pragma once
#include "engines/raster/tile.h"

namespace rakelight::raster {

/// The background of pictures of this list is the environment.
bool has_sky(const DrawList& list);
/// Its display values at the pixels of a tile where `visible` [tile_pixels] is -1: into TileScratch::display.
void put_sky(const TileJob& job, std::size_t tile, const std::int32_t* visible, TileScratch& scratch);
/// The environment's picture at every pixel of a tile. @param color  [tile_pixels]
void fill_sky(const TileJob& job, std::size_t tile, std::vector<vec4>& color, TileScratch& scratch);

}  // namespace rakelight::raster
