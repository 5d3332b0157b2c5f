// SPDX-License-Identifier: Apache-2.0
// Replaces ray casting in builds without the engine trace: bake_maps() throws before.
#include <rakelight/bake/lightmap.h>

#include "bake/bake_texels.h"

namespace rakelight::bake {

std::vector<std::uint8_t> bake_texels(const Scene&, const Scene&, const Scene*, const BakeOptions&, BakeResult&,
                                      Context&) {
    throw Error(ErrorCode::failed, "this build follows no rays");
}

}  // namespace rakelight::bake

namespace rakelight {

Lightmap with_lightmap(Scene scene, const RadiositySettings& settings, const LightmapOptions&,
                       RadiosityReport& solution, LightmapReport&, Context& context) {
    return {.scene = with_radiosity(std::move(scene), settings, solution, context)};  // which throws
}

}  // namespace rakelight
