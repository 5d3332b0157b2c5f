// SPDX-License-Identifier: Apache-2.0
// What prepare() of an engine on the processor makes of a scene: what every engine draws (shading/draw_list.h), with the
// textures as the kernels sample them.
#pragma once
#include "cpu_shading/material_views.h"
#include "shading/draw_list.h"

namespace rakelight::cpu_shading {

struct DrawList : shading::DrawList {
    MaterialViews views;

    const MaterialView& view(std::uint32_t draw) const { return views.materials[draws[draw].material]; }
};

/// Flattens a valid, posed scene. The textures point into the cache.
DrawList make_draw_list(Scene scene, shading::TextureCache& textures, Context& context);

}  // namespace rakelight::cpu_shading
