// SPDX-License-Identifier: Apache-2.0
// The texels of a lightmap: the color of an unlit surface in its texture space.
#pragma once
#include <rakelight/bake/lightmap.h>

namespace rakelight::bake {

struct LightmapTexels {
    std::vector<vec3> color;  ///< [height * width] linear RGB
    std::vector<std::uint32_t>
        material;  ///< [height * width] material of the texel; no_index: outside of charts and padding
    MemoryCharge charge;
};

/// Mean of the samples per texel; charts are extended by the padding.
/// @param lit  unlit, with normals; all meshes that have texture coordinates `set` are on the map
/// @param report gets the statistics of charts and texels
LightmapTexels lightmap_texels(const Scene& lit, std::uint32_t set, const LightmapOptions& options,
                               LightmapReport& report, Context& context);

}  // namespace rakelight::bake
