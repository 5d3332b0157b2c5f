// SPDX-License-Identifier: Apache-2.0
// The texels of a lightmap: what an unlit surface shows, laid out on its own texture coordinates.
#pragma once
#include <rakelight/lightmap.h>

namespace rakelight::bake {

struct LightmapTexels {
    std::vector<vec3> color;  ///< [height * width] linear RGB
    std::vector<std::uint32_t>
        material;  ///< [height * width] whose it is; no_index: of none, the padding reached no chart
    MemoryCharge charge;
};

/// The mean of a texel's samples; charts are continued as far as the padding goes.
/// @param lit  unlit, with normals; all meshes that have texture coordinates `set` are on the map
/// @param report  gets what is counted of charts and texels
LightmapTexels lightmap_texels(const Scene& lit, std::uint32_t set, const LightmapOptions& options,
                               LightmapReport& report, Context& context);

}  // namespace rakelight::bake
