// SPDX-License-Identifier: Apache-2.0
// The picture with lighting evaluated another number of times, for `rakelight stages`.
#pragma once
#include <vector>

#include "engines/raster/inspect/inspection.h"

namespace rakelight::raster {

struct ShadedPicture {
    std::vector<vec4> color;  ///< [width * height] linear, row by row, row 0 on top
    RenderStats stats;        ///< of triangles, and lighting_evaluations
};

/// The whole picture, as Engine::render() draws it with that shading. No remarks are made.
/// @throws Error failed: cancelled
ShadedPicture draw_shaded(const Inspection& of, Shading shading, Context& context);

}  // namespace rakelight::raster
