// SPDX-License-Identifier: Apache-2.0
// What prepare() makes of a scene: what every engine draws (shading/draw_list.h), with the textures as the kernels sample
// them.
#pragma once
#include <deque>
#include <memory>

#include "engines/raster/kernels/kernel_types.h"
#include "shading/draw_list.h"
#include "shading/environment.h"

namespace rakelight::raster {

using shading::Draw, shading::DrawMaterial;

struct DrawList : shading::DrawList {
    std::vector<MaterialView> views;                                ///< [materials]
    std::deque<TextureView> textures;                               ///< what their slots point to
    std::shared_ptr<const shading::PackedEnvironment> environment;  ///< null: none; textures/environment_maps.h
    EnvironmentView environment_view{};                             ///< of it

    const MaterialView& view(std::uint32_t draw) const { return views[draws[draw].material]; }
};

/// Flattens a valid, posed scene. The textures point into the cache.
DrawList make_draw_list(Scene scene, shading::TextureCache& textures, Context& context);

}  // namespace rakelight::raster
