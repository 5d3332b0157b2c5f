// SPDX-License-Identifier: Apache-2.0
// What the soft engine's stages leave at every pixel of a whole picture, for `rakelight stages`.
#pragma once
#include <cstdint>
#include <vector>

#include "engines/raster/inspection.h"

namespace rakelight::raster {

/// One float RGB picture a term.
struct TermPictures {
    std::vector<vec3> ambient, diffuse, specular;
};

/// Arrays are [width * height], row by row, row 0 on top.
struct PixelStageData {
    std::vector<std::uint16_t> overdraw;            ///< triangles that are drawn over the pixel's center, at most 65535
    std::vector<std::uint8_t> culled;               ///< whether culling dropped: 1 a face seen from behind, 2 one from the front
    std::vector<float> distance;                    ///< [m] along the view axis; +infinity where nothing opaque is
    std::vector<std::uint32_t> draw, triangle;      ///< the visible surface; `none` where nothing opaque is
    std::vector<vec3> normal;                       ///< that is lit
    std::vector<TermPictures> lights;               ///< of the visible surface, as Scene::lights but at most `max_lights`
    std::vector<vec3> emission;
    std::vector<vec4> color;                        ///< the picture, linear
};

/// Runs the pixel stages. Memory: about 60 bytes a pixel and 36 for each light.
/// @param open   geometry with what culling drops
/// @param drawn  geometry without it
/// @throws Error failed: cancelled
PixelStageData inspect_pixels(const Inspection& of, const Inspection::Geometry& open, const Inspection::Geometry& drawn,
                              std::size_t max_lights, Context& context);

}  // namespace rakelight::raster
