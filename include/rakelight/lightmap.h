// SPDX-License-Identifier: Apache-2.0
// Lightmaps: the light of surfaces as a picture on texture coordinates of its own, for engines that draw no more than textures.
#pragma once
#include <cstdint>

#include <rakelight/context.h>
#include <rakelight/export.h>
#include <rakelight/image.h>
#include <rakelight/radiosity.h>
#include <rakelight/scene.h>

namespace rakelight {

/// How a lightmap is laid out.
struct LightmapOptions {
    int width = 1024, height = 1024;  ///< [px] 1..16384
    int samples = 4;                  ///< a texel: 1, 4 or 16, on a regular grid
    int padding = 8;                  ///< [px] 0..1024: by how much charts are continued
    int chart_margin = 8;             ///< [px] 1..1024: left free between charts
};

/// What became of a lightmap.
struct LightmapReport {
    std::uint32_t charts = 0;       ///< pieces of the surface that are connected on the map
    std::uint32_t overlapping = 0;  ///< of them: lie on themselves somewhere
    std::uint64_t texels = 0;       ///< that charts cover or touch
    double texels_per_meter = 0;    ///< of the charts
    double brightest = 0;           ///< radiance of the brightest component of a texel
};

/// A scene that shows its light by a texture.
struct Lightmap {
    /// Its own triangles, black, with the map as the emission texture of every lit material: the last texture of the scene, on
    /// the last set of texture coordinates (set 1, unless the model has several itself). Emission is the brightest that a
    /// material sends out. Two-sided surfaces become two one-sided ones; alpha stays.
    Scene scene{};
    Pixels picture{};  ///< 8 bits, sRGB: radiance over the emission of the material
};

/// What with_radiosity() shows, as a texture. The same bits for any number of threads.
/// @param scene  valid, posed and prepared, with normals, with the lights of the picture
/// @throws Error usage: impossible options or settings, no room for the charts; and as with_radiosity()
RL_API Lightmap with_lightmap(Scene scene, const RadiositySettings& settings, const LightmapOptions& options,
                              RadiosityReport& solution, LightmapReport& report, Context& context);

}  // namespace rakelight
