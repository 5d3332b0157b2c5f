// SPDX-License-Identifier: Apache-2.0
// Everything about one pixel, as plain data.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <rakelight/scene/scene.h>

#include "engines/raster/inspect/traced_pixel.h"
#include "engines/raster/lights/lit_corner.h"
#include "shading/sample_positions.h"

namespace rakelight::raster {

/// What became of a triangle at a sample of a pixel that it covers, and of it as a whole: the first of these that one
/// of its samples met.
enum class Fate : std::uint8_t {
    visible,       ///< the nearest one that is not seen through: its color is the pixel's
    blended,       ///< seen through, before the visible one: its color is laid over
    masked_out,    ///< its alpha is below the material's cutoff here
    hidden,        ///< behind the visible one
    culled_back,   ///< not drawn: seen from behind
    culled_front,  ///< not drawn: seen from the front
};

/// A sample of a pixel that a triangle covers.
struct CoveredSample {
    int sample = 0;       ///< into sample_positions(): 0 is the center in pictures of one sample
    float depth_key = 0;  ///< what is compared: greater is nearer
    float alpha = 1;      ///< of masked and blended materials
    Fate fate = Fate::hidden;
};

/// How depth is found at a pixel: the key at a pixel of reference, and what it changes by for each pixel to the right and down.
struct DepthPlane {
    int x = 0, y = 0;                ///< the reference: the first pixel of the triangle's box in its tile
    float key = 0;                   ///< there
    float slope_x = 0, slope_y = 0;  ///< [1/px] of the key
    float by_steps = 0;              ///< key + slope_y steps down + slope_x steps to the right, as the engine rounds it
    double exact = 0;                ///< of the plane through the corners, in double
};

/// A triangle that covers a sample of a pixel.
struct CoveringTriangle {
    std::uint32_t draw = no_index, triangle = no_index;  ///< into DrawList::draws; which triangle of its mesh
    std::array<std::uint32_t, 3> vertex{};               ///< into the mesh's arrays
    bool is_back = false;                                ///< seen from behind
    bool is_clipped = false;                             ///< this is a piece: the triangle passes a clipping plane
    float depth_key = 0;                                 ///< of the nearest sample, as distance and alpha
    float distance = 0;                                  ///< [m] along the view axis
    DepthPlane plane;  ///< likewise; depth_key is `by_steps` between those of the corners
    float alpha = 1;
    Fate fate = Fate::hidden;
    std::vector<CoveredSample> samples;  ///< at least one, in their order
};

/// A point that was lit before there were pixels, with what each light gave it.
struct TracedCorner {
    LitCorner corner;
    std::vector<TracedLight> lights;  ///< as Scene::lights; terms per unit of reflectance
    std::vector<TracedParts> parts;   ///< [lights]
};

/// A layer at one sample.
struct LaidSample {
    int sample = 0;
    int place = 0;       ///< among the layers of the sample, the farthest is 0
    vec4 before, after;  ///< the sample's color, linear
};

/// One surface that was shaded for the pixel, once for all samples that show it.
struct ShadedLayer {
    std::size_t triangle = 0;  ///< into PixelExplanation::triangles
    vec2 place;                ///< [px] from the pixel's center to where it was shaded, y down
    PixelTrace trace{};
    std::vector<TracedTexels> texels;  ///< [texture_role_count]
    std::vector<TracedLight> lights;   ///< as Scene::lights; empty for unlit surfaces and where trace.is_lit_at_corners
    std::vector<TracedParts> parts;    ///< [lights], then those of what comes from the environment and of the emission
    std::vector<TracedCorner> corners;  ///< where trace.is_lit_at_corners: the three vertices, or the centroid alone
    int reflection_model = 0, reflection_form = 0;  ///< shading::ReflectionModel and ::ReflectionForm
    std::optional<WardForm> ward_form;              ///< where the model is Ward's
    bool is_unlit = false, is_blended = false;
    std::vector<LaidSample> samples;  ///< those that show it
};

/// One sample of the pixel when all layers are laid.
struct SeenSample {
    shading::SamplePosition at;
    std::size_t triangle = SIZE_MAX;  ///< the visible one, into PixelExplanation::triangles; SIZE_MAX: the background
    vec4 color;                       ///< linear
};

/// A line or a point of the scene.
struct VisibleMark {
    std::uint32_t node = no_index, mesh = no_index, material = no_index;  ///< of the scene
    bool is_point = false;
};

struct PixelExplanation {
    int x = 0, y = 0;
    vec4 background;
    std::vector<CoveringTriangle> triangles;  ///< nearest first
    /// Visible surfaces, in the order of the first sample that shows them, then blended ones far to near, in the order of the
    /// first sample that shows them.
    std::vector<ShadedLayer> layers;
    std::vector<SeenSample> samples;  ///< as many as the picture has a pixel
    vec4 sum;                         ///< the result of the layers: the mean of the samples
    vec4 color;                       ///< the pixel's surfaces as the engine draws them: equal to `sum` to the bit, but
                                      ///< where more layers than BlendedLayers::most_waiting are out of order
    bool has_marks = false;           ///< lines or points of the scene may lie over them
    std::optional<VisibleMark> mark;  ///< the opaque one that hides them at the pixel's center
};

}  // namespace rakelight::raster
