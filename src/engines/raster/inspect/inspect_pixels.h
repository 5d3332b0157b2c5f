// SPDX-License-Identifier: Apache-2.0
// What the soft engine's stages leave at every pixel of a whole picture, for `rakelight stages`.
#pragma once
#include <cstdint>
#include <vector>

#include "engines/raster/inspect/inspection.h"

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
    std::vector<std::uint16_t> overdraw;  ///< opaque surfaces over the pixel, as channel_overdraw; at most 65535
    std::vector<std::uint8_t> faces;  ///< bits, what covers the center: 1 a face seen from behind that culling dropped,
                                      ///< 2 one from the front, 4 one drawn
    std::vector<float> distance;      ///< [m] along the view axis; +infinity where nothing opaque is
    std::vector<float> depth_key;     ///< what is compared there: greater is nearer; -1 where nothing opaque is
    std::vector<vec2> depth_slope;    ///< [1/px] its change per pixel to the right and down, on the triangle's plane
    std::vector<std::uint32_t> draw, triangle;  ///< the visible surface; `no_index` where nothing opaque is
    std::vector<vec3> normal;                   ///< that is lit
    /// As Scene::lights but at most `max_lights`: what the terms of the visible surface and of blended ones contribute
    /// to the picture. A layer's count by its alpha, those behind it by what it lets through.
    std::vector<TermPictures> lights;
    std::vector<vec3> other_lights;  ///< the same, of all lights beyond `max_lights` together; empty: there are none
    std::vector<vec3> emission;      ///< the same
    std::vector<vec3> own_color;     ///< the same, of surfaces that are not lit, and of the background behind layers
    /// The same, of the light from the environment: what is reflected diffusely, and the gloss. Empty: there is none.
    std::vector<vec3> around_diffuse, around_specular;
    std::vector<vec3> transmitted;  ///< the same, of what is seen through surfaces; empty: none is transmissive
    std::vector<vec3> fog;          ///< the same, of the fog's own light; empty: there is none
    std::vector<float> fog_share;   ///< 0..1: how much of the visible surface is seen through the fog; empty as `fog`
    /// As `lights`: 0..1, how much of it reaches the visible surface; < 0 where it lights nothing at the pixel. Empty:
    /// nothing casts shadows.
    std::vector<std::vector<float>> seen;
    /// How far the relief of a height map moves the texture coordinates of the visible surface, and the height that
    /// the ray hits: 0..1 as in the map, < 0 where there is no relief. Empty: no material has one.
    std::vector<vec2> relief_shift;
    std::vector<float> relief_height;
    std::vector<vec4> opaque;               ///< the picture before blended surfaces; empty where no material blends
    std::vector<std::uint8_t> layer_count;  ///< blended surfaces laid over the pixel, at most 255; empty with `opaque`
    std::vector<BlendedLayer> layers;       ///< the first of each pixel, as many as there are, at most most_layers
    std::vector<vec4> color;                ///< the picture, linear
    // Of pictures of several samples per pixel, else empty. All else is of the pixels' centers.
    std::vector<vec4> center_color;               ///< the picture of one sample
    std::vector<std::uint8_t> samples_covered;    ///< by something opaque
    std::vector<std::uint8_t> visible_triangles;  ///< by the samples: so often the pixel was shaded; opaque ones
    std::vector<float> sample_spread;  ///< greatest difference of a component between samples, each at most 1

    /// Something that is drawn shows at the pixel's center.
    bool shows(std::size_t pixel) const {
        return draw[pixel] != no_index || (!layer_count.empty() && layer_count[pixel] > 0);
    }
    const std::vector<vec4>& centers() const { return center_color.empty() ? color : center_color; }
};

/// Runs the pixel stages. Memory: about 72 bytes per pixel, 36 for each light and 4 more with shadows, 12 for all lights
/// beyond `max_lights` together, 24 for the light from the environment, 16 for fog, 12 for relief.
/// @param open   geometry with what culling drops
/// @param drawn  geometry without it
/// @throws Error failed: cancelled
PixelStageData inspect_pixels(const Inspection& of, const Inspection::Geometry& open, const Inspection::Geometry& drawn,
                              std::size_t max_lights, Context& context);

}  // namespace rakelight::raster
