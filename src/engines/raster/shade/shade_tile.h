// SPDX-License-Identifier: Apache-2.0
// Colors of the surfaces that a tile shows, before anything is laid over them.
#pragma once
#include "engines/raster/tile.h"

namespace rakelight::raster {

/// Colors of the visible pixels. True where something is to be laid over them.
bool shade_opaque(const TileJob& job, std::size_t tile, TileScratch& scratch);
/// `wanted`: what the first `count` of `shown` are, each once; `batch_triangle`: which of them.
void find_wanted(const TileJob& job, std::size_t tile, std::size_t count, TileScratch& scratch);

}  // namespace rakelight::raster
