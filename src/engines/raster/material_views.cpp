// SPDX-License-Identifier: Apache-2.0
// Scene materials -> what the kernels read: factors, texture slots, color spaces by role.
#include <cmath>

#include "engines/raster/draw_list.h"
#include "engines/raster/normal_map_remarks.h"
#include "math/functions.h"
#include "math/linear.h"
#include "scene/material_table.h"
#include "shading/choices.h"

namespace rakelight::raster {
namespace {

/// Whether pictures show what the texture is read for.
bool is_read(const TextureRole& role, const Material& m) {
    if (role.number == role_opacity) return m.alpha_mode != AlphaMode::opaque;
    if (m.model == MaterialModel::unlit) return role.number == role_base_color;
    return role.is_of(m.model) && !role.layer.silences(m);
}

std::vector<const TextureRole*> roles_of(const Material& m) {
    std::vector<const TextureRole*> roles;
    for (const TextureRole& role : texture_roles())
        if (role.in(m) && is_read(role, m)) roles.push_back(&role);
    return roles;
}

void copy(float (&to)[3], vec3 from) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

/// Roughness of the GGX, Beckmann or Ward lobe that is as wide as Blinn-Phong's of this exponent: alpha^2 = 2 / (n + 2)
/// (Karis 2013, "Specular BRDF Reference").
float roughness_of_exponent(float n) { return float(std::sqrt(std::sqrt(2 / (double(n) + 2)))); }

/// What lighting models of more parameters read.
void add_full_factors(const Material& m, MaterialView& v) {
    const MetallicRoughnessParameters& p = m.metallic_roughness;
    v.lobe_roughness = roughness_of_exponent(v.shininess);
    v.sigma = m.sigma_rad.value_or(-1);
    const vec2 alpha = m.ward_alpha.value_or(vec2{0, 0});
    v.ward_alpha[0] = alpha.x, v.ward_alpha[1] = alpha.y;
    v.anisotropy = p.anisotropy;
    v.anisotropy_axis[0] = float(math::cos(double(p.anisotropy_rotation_rad)));
    v.anisotropy_axis[1] = float(math::sin(double(p.anisotropy_rotation_rad)));
    v.clearcoat = p.clearcoat, v.clearcoat_roughness = p.clearcoat_roughness;
    v.clearcoat_normal_scale = p.clearcoat_normal_scale;
    copy(v.sheen_color, p.sheen_color);
    v.sheen_roughness = p.sheen_roughness;
}

MaterialView factors(const Material& m) {
    MaterialView v{};
    v.unlit = m.model == MaterialModel::unlit;
    v.metallic_roughness = m.model == MaterialModel::metallic_roughness;
    const vec4 c = m.base_color;
    v.base_color[0] = c.x, v.base_color[1] = c.y, v.base_color[2] = c.z, v.base_color[3] = c.w;
    if (m.model != MaterialModel::unlit) copy(v.emission, m.emission);  // KHR_materials_unlit: the base color alone
    copy(v.ambient, m.classical.ambient);
    copy(v.specular, m.classical.specular);
    v.shininess = m.classical.shininess < 1 ? 1 : m.classical.shininess;
    if (m.model == MaterialModel::classical && v.shininess <= 1024 && v.shininess == std::floor(v.shininess))
        v.whole_exponent = std::int32_t(v.shininess);
    v.metallic = m.metallic_roughness.metallic;
    v.roughness = m.metallic_roughness.roughness;
    copy(v.dielectric_color, m.metallic_roughness.specular_color * ior_f0(m.metallic_roughness.ior));
    v.specular_strength = m.metallic_roughness.specular;
    v.normal_scale = m.normal_scale;
    v.occlusion_strength = m.occlusion_strength;
    v.alpha_cutoff = m.alpha_mode == AlphaMode::mask ? m.alpha_cutoff : -1;
    v.blend = m.alpha_mode == AlphaMode::blend;
    add_full_factors(m, v);
    return v;
}

/// KHR_texture_transform as the two rows of an affine matrix.
TextureSlot slot_for(const TextureUse& use, const TextureView& view) {
    const double c = math::cos(use.transform.rotation_rad), s = math::sin(use.transform.rotation_rad);
    const vec2 scale = use.transform.scale, offset = use.transform.offset;
    TextureSlot slot = {&view,
                        std::int32_t(use.texcoord_set),
                        0,
                        float(c * scale.x),
                        float(s * scale.y),
                        float(-s * scale.x),
                        float(c * scale.y),
                        offset.x,
                        offset.y};
    slot.is_transformed = slot.uu != 1 || slot.uv != 0 || slot.vu != 0 || slot.vv != 1 || slot.u0 != 0 || slot.v0 != 0;
    return slot;
}

TextureKey key_of(const Texture& texture, ColorSpace space) {
    return {texture.image, space, texture.sampler.wrap_u, texture.sampler.wrap_v};
}

/// Whether two slots read the same texels of their textures at every pixel.
bool share_footprint(const TextureSlot& a, const TextureSlot& b) {
    if (!a.view || !b.view || a.texcoord_set != b.texcoord_set) return false;
    if (a.uu != b.uu || a.uv != b.uv || a.vu != b.vu || a.vv != b.vv || a.u0 != b.u0 || a.v0 != b.v0) return false;
    const TextureView &s = *a.view, &t = *b.view;
    return s.width[0] == t.width[0] && s.height[0] == t.height[0] && s.levels == t.levels && s.wrap_u == t.wrap_u &&
           s.wrap_v == t.wrap_v && s.mip == t.mip && s.minify_linear == t.minify_linear &&
           s.magnify_linear == s.minify_linear && t.magnify_linear == t.minify_linear;
}

/// Fills the materials of a draw list.
class MaterialViews {
public:
    MaterialViews(DrawList& list, const TextureCache& textures, Report& report)
        : list_(list), textures_(textures), report_(report), remarks_(list.scene, report) {}

    /// @param is_drawn  else its textures are not looked at
    void add(Material m, std::uint32_t scene_material, bool is_drawn) {
        const TextureUse& emission = m.emission_texture;
        if (is_drawn && m.model != MaterialModel::unlit && emission && !pixels_of(emission, ColorSpace::srgb))
            drop_emission(m, report_, list_.scene.source, m.name);
        DrawMaterial out;
        out.view = factors(m);
        out.scene_material = scene_material;
        out.two_sided = shading::is_two_sided(m);
        out.classical = m.model == MaterialModel::classical;
        if (is_drawn)
            for (const TextureRole* const role : roles_of(m)) bind(m, *role, out.view);
        out.view.shares_footprint = share_footprint(out.view.map[role_base_color], out.view.map[role_normal]);
        list_.materials.push_back(out);
    }

private:
    static constexpr std::uint32_t texcoord_sets = 2;

    /// Null: it could not be had, which has been said, or its coordinates are left out.
    const TextureData* pixels_of(const TextureUse& use, ColorSpace space) const {
        if (use.texcoord_set >= texcoord_sets) return nullptr;
        return textures_.find(key_of(list_.scene.textures[use.texture], space));
    }

    void bind(const Material& m, const TextureRole& role, MaterialView& view) {
        const TextureUse& use = role.in(m);
        if (use.texcoord_set >= texcoord_sets)
            return report_.add(Remark::dropped, list_.scene.source, m.name,
                               "texture left out: the soft engine has texture coordinate sets 0 and 1");
        const TextureData* pixels = pixels_of(use, role.space);
        if (!pixels) return;
        if (role.number == role_normal) remarks_.look_at(m, use, *pixels);
        if (role.number == role_height) remarks_.look_at_heights(m, use, *pixels);
        list_.views.push_back(with_filters(*pixels, list_.scene.textures[use.texture].sampler));
        view.map[role.number] = slot_for(use, list_.views.back());
        view.uses_texcoords[use.texcoord_set] = 1;
    }

    DrawList& list_;
    const TextureCache& textures_;
    Report& report_;
    NormalMapRemarks remarks_;
};

}  // namespace

void fill_materials(DrawList& list, TextureCache& textures, Context& context) {
    std::vector<Material> materials = list.scene.materials;
    materials.emplace_back();  // the default one, for meshes without
    std::vector<TextureKey> uses;
    std::vector<bool> is_drawn(materials.size(), false);
    for (const Draw& d : list.draws) is_drawn[d.material] = true;
    for (std::size_t i = 0; i < materials.size(); ++i)
        if (is_drawn[i])
            for (const TextureRole* const role : roles_of(materials[i]))
                uses.push_back(key_of(list.scene.textures[role->in(materials[i]).texture], role->space));
    textures.update(uses, context);
    MaterialViews views(list, textures, context.report());
    for (std::size_t i = 0; i < materials.size(); ++i)
        views.add(materials[i], i + 1 < materials.size() ? std::uint32_t(i) : none, is_drawn[i]);
}

}  // namespace rakelight::raster
