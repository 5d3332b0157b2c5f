// SPDX-License-Identifier: Apache-2.0
#include "cpu_shading/material_views.h"

#include "cpu_shading/textures.h"
#include "scene/materials/material_table.h"

namespace rakelight::cpu_shading {
namespace {

/// Whether two slots are read at the same place of their pictures at every point.
bool have_same_coordinates(const TextureSlot& a, const TextureSlot& b) {
    return a.texcoord_set == b.texcoord_set && a.uu == b.uu && a.uv == b.uv && a.vu == b.vu && a.vv == b.vv &&
           a.u0 == b.u0 && a.v0 == b.v0;
}

/// Whether a footprint in one texture is that in the other one.
bool have_same_texels(const TextureView& s, const TextureView& t) {
    return s.width[0] == t.width[0] && s.height[0] == t.height[0] && s.levels == t.levels && s.wrap_u == t.wrap_u &&
           s.wrap_v == t.wrap_v && s.mip == t.mip && s.minify_linear == t.minify_linear &&
           s.magnify_linear == s.minify_linear && t.magnify_linear == t.minify_linear;
}

bool share_footprint(const TextureSlot& a, const TextureSlot& b) {
    return a.view && b.view && have_same_coordinates(a, b) && have_same_texels(*a.view, *b.view);
}

/// The maps that lie as the base color's, itself among them; a height map is read at levels of its own.
std::uint32_t shared_maps(const MaterialView& m) {
    std::uint32_t shared = 0;
    for (int role = 0; role < texture_role_count; ++role)
        if (role != role_height && share_footprint(m.map[role_base_color], m.map[role])) shared |= 1u << role;
    return shared;
}

/// Whether two slots show the same texels: one picture, filtered alike.
bool show_the_same(const TextureSlot& a, const TextureSlot& b) {
    if (!a.view || !b.view || !have_same_coordinates(a, b)) return false;
    const TextureView &s = *a.view, &t = *b.view;
    return s.rgba8 == t.rgba8 && s.rgba16 == t.rgba16 && s.rgba32f == t.rgba32f && s.mip == t.mip &&
           s.minify_linear == t.minify_linear && s.magnify_linear == t.magnify_linear;
}

/// The slot of one map, whose texture is there.
TextureSlot slot_for(const shading::TextureCache& textures, const TextureRole& role, const shading::DrawMaterial& drawn,
                     const shading::DrawList& list, MaterialViews& views) {
    const TextureUse& use = role.in(list.scene_material(drawn));
    const Sampler& sampler = list.scene.textures[use.texture].sampler;
    const shading::LoadedTexture* const loaded = textures.find(shading::key_of(list, drawn, role));
    views.textures.push_back(with_filters(static_cast<const TextureData&>(*loaded->packed), sampler));
    TextureSlot slot{shading::uv_transform(use), &views.textures.back(), std::int32_t(use.texcoord_set), 0};
    slot.is_transformed = !shading::is_identity(slot);
    return slot;
}

MaterialView picture_camera_of(const shading::TextureCache& textures, const shading::DrawMaterial& drawn,
                               const shading::DrawList& list, MaterialViews& views) {
    MaterialView view{};
    static_cast<shading::MaterialFactors&>(view) = drawn.factors;
    for (const TextureRole& role : texture_roles()) {
        if (!drawn.maps[std::size_t(role.number)]) continue;
        view.map[role.number] = slot_for(textures, role, drawn, list, views);
        view.uses_texcoords[view.map[role.number].texcoord_set] = 1;
    }
    for (const TextureSlot& slot : view.map) view.has_float_maps |= slot.view && slot.view->rgba32f;
    view.shared_maps = shared_maps(view);
    view.occlusion_in_metallic = show_the_same(view.map[role_occlusion], view.map[role_metallic_roughness]);
    return view;
}

}  // namespace

MaterialViews make_material_views(const shading::DrawList& list, const shading::TextureCache& textures) {
    MaterialViews views;
    views.materials.reserve(list.materials.size());
    for (const shading::DrawMaterial& drawn : list.materials)
        views.materials.push_back(picture_camera_of(textures, drawn, list, views));
    return views;
}

}  // namespace rakelight::cpu_shading
