// SPDX-License-Identifier: Apache-2.0
// The triangles of an explained pixel, when the fate of all their samples is known.
#pragma once
#include "engines/raster/inspect/open_scene.h"

namespace rakelight::raster {

inline constexpr std::size_t no_triangle = SIZE_MAX;  ///< instead of a triangle

/// Each triangle's own fate, and the numbers of its nearest sample.
void summarize(PixelExplanation& pixel, const OpenScene& of);

/// Nearest first; layers and samples follow.
void sort_by_depth(PixelExplanation& pixel);

}  // namespace rakelight::raster
