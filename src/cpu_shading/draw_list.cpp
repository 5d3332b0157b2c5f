// SPDX-License-Identifier: Apache-2.0
#include "cpu_shading/draw_list.h"

#include "cpu_shading/textures.h"

namespace rakelight::cpu_shading {

DrawList make_draw_list(Scene scene, shading::TextureCache& textures, Context& context) {
    DrawList list{shading::make_draw_list(std::move(scene), textures, CpuTexturePacker(), context), {}};
    list.views = make_material_views(list, textures);
    return list;
}

}  // namespace rakelight::cpu_shading
