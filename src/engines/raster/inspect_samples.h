// SPDX-License-Identifier: Apache-2.0
// What the samples of a pixel show, for `rakelight stages` of pictures with several.
#pragma once
#include <vector>

#include "engines/raster/inspect_pixels.h"
#include "engines/raster/tile.h"

namespace rakelight::raster {

/// Tiles of `drawn` as Engine::render() draws them, in scalar words, with all attributes in the records.
TileJob tile_job(const Inspection& of, const Inspection::Geometry& drawn);

/// Draws one tile of a picture of several samples, into the arrays of `out` that such pictures have, and `color`.
void note_samples(const TileJob& job, std::size_t tile, const RenderSettings& settings, TileScratch& scratch,
                  PixelStageData& out);

/// A part of such a picture.
struct SampleColors {
    Window window;
    std::vector<vec4> color;  ///< [window pixels][samples] linear, when all layers are laid
};
/// @param window  [px] lies in one of the tiles of `drawn`
SampleColors inspect_samples(const Inspection& of, const Inspection::Geometry& drawn, Window window);

}  // namespace rakelight::raster
