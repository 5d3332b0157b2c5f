// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/draw_list.h"

#include "engines/raster/textures/textures.h"
#include "scene/material_table.h"

namespace rakelight::raster {
namespace {

/// Whether two slots read the same texels of their textures at every pixel.
bool share_footprint(const TextureSlot& a, const TextureSlot& b) {
    if (!a.view || !b.view || a.texcoord_set != b.texcoord_set) return false;
    if (a.uu != b.uu || a.uv != b.uv || a.vu != b.vu || a.vv != b.vv || a.u0 != b.u0 || a.v0 != b.v0) return false;
    const TextureView &s = *a.view, &t = *b.view;
    return s.width[0] == t.width[0] && s.height[0] == t.height[0] && s.levels == t.levels && s.wrap_u == t.wrap_u &&
           s.wrap_v == t.wrap_v && s.mip == t.mip && s.minify_linear == t.minify_linear &&
           s.magnify_linear == s.minify_linear && t.magnify_linear == t.minify_linear;
}

/// The slot of one map, whose texture is there.
TextureSlot slot_for(const shading::TextureCache& textures, const TextureRole& role, const TextureUse& use,
                     DrawList& list) {
    const Texture& texture = list.scene.textures[use.texture];
    const shading::LoadedTexture* const loaded = textures.find(shading::key_of(texture, role.space));
    list.textures.push_back(with_filters(static_cast<const TextureData&>(*loaded->packed), texture.sampler));
    TextureSlot slot{shading::uv_transform(use), &list.textures.back(), std::int32_t(use.texcoord_set), 0};
    slot.is_transformed = !shading::is_identity(slot);
    return slot;
}

MaterialView view_of(const shading::TextureCache& textures, const DrawMaterial& drawn, DrawList& list) {
    MaterialView view{};
    static_cast<shading::MaterialFactors&>(view) = drawn.factors;
    for (const TextureRole& role : texture_roles()) {
        if (!drawn.maps[std::size_t(role.number)]) continue;
        const TextureUse& use = role.in(list.scene_material(drawn));
        view.map[role.number] = slot_for(textures, role, use, list);
        view.uses_texcoords[use.texcoord_set] = 1;
    }
    view.shares_footprint = share_footprint(view.map[role_base_color], view.map[role_normal]);
    return view;
}

}  // namespace

DrawList make_draw_list(Scene scene, shading::TextureCache& textures, Context& context) {
    DrawList list{shading::make_draw_list(std::move(scene), textures, SoftTexturePacker(), context), {}, {}, {}, {}};
    list.views.reserve(list.materials.size());
    for (const DrawMaterial& drawn : list.materials) list.views.push_back(view_of(textures, drawn, list));
    return list;
}

}  // namespace rakelight::raster
