// SPDX-License-Identifier: Apache-2.0
// What the samples of a pixel show, for `rakelight stages` of pictures with several.
#pragma once
#include <vector>

#include "engines/raster/inspect/inspection.h"

namespace rakelight::raster {

/// A part of such a picture.
struct SampleColors {
    Window window;
    std::vector<vec4> color;  ///< [window pixels][samples] linear, when all layers are laid
};
/// [px] windows lie in one square of the picture's grid of such ones.
inline constexpr int sample_square = 64;
/// @param window  [px] of `drawn`
SampleColors inspect_samples(const Inspection& of, const Inspection::Geometry& drawn, Window window);

}  // namespace rakelight::raster
