// SPDX-License-Identifier: Apache-2.0
// Lightmaps: the light of surfaces, stored in a texture with its own texture coordinates, for renderers that do not
// compute light.
#pragma once
#include <cstdint>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>
#include <rakelight/image/image.h>
#include <rakelight/radiosity/radiosity.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Size and layout of a lightmap.
struct LightmapOptions {
    int width = 1024, height = 1024;  ///< [px] 1..16384
    int samples = 4;                  ///< samples per texel: 1, 4 or 16, on a regular grid
    int padding = 8;                  ///< [px] 0..1024: width by which charts are extended beyond their borders
    int chart_margin = 8;             ///< [px] 1..1024: free space between charts
};

/// Statistics of a lightmap.
struct LightmapReport {
    std::uint32_t charts = 0;       ///< connected pieces of the surface on the map
    std::uint32_t overlapping = 0;  ///< charts that overlap themselves
    std::uint64_t texels = 0;       ///< texels that charts cover or touch
    double texels_per_meter = 0;    ///< resolution of the charts
    double brightest = 0;           ///< largest radiance of a color component of any texel
};

/// A scene whose light is stored in a texture.
struct Lightmap {
    /// The triangles of the input with black materials. The lightmap is the last texture of the scene, and the emission
    /// texture of every material that was lit. Its texture coordinates are the last set of each mesh: set 1, or a
    /// higher set if the model already uses set 1. Material::emission is the largest radiance on the material. A
    /// two-sided surface becomes two one-sided surfaces; alpha is kept.
    Scene scene{};
    Pixels picture{};  ///< the lightmap, 8 bits, sRGB: radiance divided by Material::emission
};

/// The solution of with_radiosity(), stored as a texture. Bit-identical for any number of threads.
/// @param scene  valid, posed and prepared, with normals, with the lights of the picture
/// @throws Error usage: impossible options or settings, or the charts do not fit; and as with_radiosity()
RL_API Lightmap with_lightmap(Scene scene, const RadiositySettings& settings, const LightmapOptions& options,
                              RadiosityReport& solution, LightmapReport& report, Context& context);

}  // namespace rakelight
