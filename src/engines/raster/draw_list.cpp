// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/draw_list.h"

#include "cpu_shading/textures.h"

namespace rakelight::raster {

DrawList make_draw_list(Scene scene, shading::TextureCache& textures, Context& context) {
    DrawList list{shading::make_draw_list(std::move(scene), textures, cpu_shading::CpuTexturePacker(), context), {}};
    list.views = cpu_shading::make_material_views(list, textures);
    return list;
}

}  // namespace rakelight::raster
