// SPDX-License-Identifier: Apache-2.0
// The samples of one tile, for inspect_pixels.h.
#pragma once
#include "engines/raster/inspect/inspect_pixels.h"
#include "engines/raster/tile.h"

namespace rakelight::raster {

/// Draws one tile of a picture of several samples, into the arrays of `out` that such pictures have, and `color`.
void note_samples(const TileJob& job, std::size_t tile, const RenderSettings& settings, TileScratch& scratch,
                  PixelStageData& out);

}  // namespace rakelight::raster
