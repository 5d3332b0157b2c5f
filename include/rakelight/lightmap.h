// SPDX-License-Identifier: Apache-2.0
// Lightmaps: the light of surfaces as a texture with texture coordinates of its own, for renderers that only draw
// textures.
#pragma once
#include <cstdint>

#include <rakelight/context.h>
#include <rakelight/export.h>
#include <rakelight/image.h>
#include <rakelight/radiosity.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Size and layout of a lightmap.
struct LightmapOptions {
    int width = 1024, height = 1024;  ///< [px] 1..16384
    int samples = 4;                  ///< per texel: 1, 4 or 16, on a regular grid
    int padding = 8;                  ///< [px] 0..1024: how far the borders of charts are extended
    int chart_margin = 8;             ///< [px] 1..1024: free space between charts
};

/// Statistics of a lightmap.
struct LightmapReport {
    std::uint32_t charts = 0;       ///< connected pieces of the surface on the map
    std::uint32_t overlapping = 0;  ///< charts that overlap themselves
    std::uint64_t texels = 0;       ///< covered or touched by charts
    double texels_per_meter = 0;    ///< resolution of the charts
    double brightest = 0;           ///< largest radiance of a color component of any texel
};

/// A scene whose light is stored in a texture.
struct Lightmap {
    /// The input's triangles in black. The map is the emission texture of every lit material and the last texture of
    /// the scene. It uses the last set of texture coordinates (set 1, unless the model has several). Emission is the
    /// largest radiance of the material. Two-sided surfaces become two one-sided ones; alpha is kept.
    Scene scene{};
    Pixels picture{};  ///< 8 bits, sRGB: radiance divided by the material's emission
};

/// The solution of with_radiosity(), stored as a texture. Bit-identical for any number of threads.
/// @param scene  valid, posed and prepared, with normals, with the lights of the picture
/// @throws Error usage: impossible options or settings, no room for the charts; and as with_radiosity()
RL_API Lightmap with_lightmap(Scene scene, const RadiositySettings& settings, const LightmapOptions& options,
                              RadiosityReport& solution, LightmapReport& report, Context& context);

}  // namespace rakelight
