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

/// What blended surfaces make of the picture, the farthest of each pixel first.
struct BlendedLayer {
    std::vector<vec4> color;   ///< after this layer; as before it where the pixel has fewer
    std::vector<float> alpha;  ///< of the layer, 0..1; 0 where the pixel has fewer
};
inline constexpr std::size_t most_layers = 4;

/// Arrays are [width * height], row by row, row 0 on top.
struct PixelStageData {
    std::vector<std::uint16_t> overdraw;            ///< triangles that are drawn over the pixel's center, at most 65535
    std::vector<std::uint8_t> culled;               ///< whether culling dropped: 1 a face seen from behind, 2 one from the front
    std::vector<float> distance;                    ///< [m] along the view axis; +infinity where nothing opaque is
    std::vector<std::uint32_t> draw, triangle;      ///< the visible surface; `none` where nothing opaque is
    std::vector<vec3> normal;                       ///< that is lit
    std::vector<TermPictures> lights;               ///< of the visible surface, as Scene::lights but at most `max_lights`
    std::vector<vec3> emission;
    std::vector<vec4> opaque;               ///< the picture before blended surfaces; empty where no material blends
    std::vector<std::uint8_t> layer_count;  ///< blended surfaces laid over the pixel, at most 255; empty with `opaque`
    std::vector<BlendedLayer> layers;       ///< the first of each pixel, as many as there are, at most most_layers
    std::vector<vec4> color;                        ///< the picture, linear
};

/// Runs the pixel stages. Memory: about 60 bytes a pixel and 36 for each light.
/// @param open   geometry with what culling drops
/// @param drawn  geometry without it
/// @throws Error failed: cancelled
PixelStageData inspect_pixels(const Inspection& of, const Inspection::Geometry& open, const Inspection::Geometry& drawn,
                              std::size_t max_lights, Context& context);

}  // namespace rakelight::raster
