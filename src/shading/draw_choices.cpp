// SPDX-License-Identifier: Apache-2.0
#include "shading/draw_choices.h"

#include <algorithm>
#include <cmath>

#include "scene/materials/material_conversion.h"
#include "scene/materials/uv_matrix.h"
#include "shading/choices.h"

namespace rakelight::shading {
namespace {

bool has_map(const DrawList& list, const Draw& draw, TextureRoleNumber number) {
    const DrawMaterial& drawn = list.material(draw);
    if (!drawn.maps[std::size_t(number)]) return false;
    const TextureUse& use = texture_roles()[std::size_t(number)].in(list.scene_material(drawn));
    return has_coordinates(list.scene.meshes[draw.mesh], use.texcoord_set);
}

/// Steps of a march: what a file says, within what a picture can be waited for.
std::int32_t steps(int wanted, int least) { return std::clamp(wanted, least, 1024); }

/// What one width of the texture along tangent and bitangent is in texture coordinates. Texels are taken as square on
/// the surface, as normal maps take them. v counts down, the bitangent points up.
/// @param map      of the height texture
/// @param tangent  of the texture to whose coordinates tangents belong; nothing moves where it maps all to a line
void set_scales(const UvMatrix& map, const UvMatrix& tangent, double aspect, ReliefFactors& out) {
    const UvMatrix to_uv = inverse(tangent);
    const UvMatrix to_map = map == tangent && !(to_uv == UvMatrix{0, 0, 0, 0}) ? UvMatrix{} : map * to_uv;
    const double along_u = std::sqrt(to_map.uu * to_map.uu + to_map.vu * to_map.vu);
    const double along_v = std::sqrt(to_map.uv * to_map.uv + to_map.vv * to_map.vv);
    const double per_u = along_u > 0 ? 1 / along_u : 0, per_v = along_v > 0 ? -aspect / along_v : 0;
    const auto put = [&](const UvMatrix& m, float(&rows)[2][2]) {
        rows[0][0] = float(m.uu * per_u), rows[0][1] = float(m.uv * per_v);
        rows[1][0] = float(m.vu * per_u), rows[1][1] = float(m.vv * per_v);
    };
    put(to_uv, out.to_uv), put(to_map, out.to_map);
}

}  // namespace

Lighting lighting_of(const DrawList& list, const Draw& draw, const RenderSettings& settings) {
    return lighting_of(list.scene_material(list.material(draw)), settings.lighting);
}

Bump bump_of(const DrawList& list, const Draw& draw, const RenderSettings& settings) {
    const Bump wanted = rakelight::bump_of(list.scene_material(list.material(draw)), settings.bump);
    if (wanted == Bump::none || wanted == Bump::displacement) return Bump::none;
    if (reads_heights(wanted) && has_map(list, draw, role_height)) return wanted;
    return has_map(list, draw, role_normal) ? Bump::normal : Bump::none;
}

ReliefFactors relief_of(const DrawList& list, const Draw& draw, const RenderSettings& settings, double aspect) {
    const Material& m = list.scene_material(list.material(draw));
    const Relief r = m.relief.value_or(settings.relief);
    const Bump bump = bump_of(list, draw, settings);
    ReliefFactors out{};
    out.technique = relief_technique(bump);
    if (out.technique == relief_none) return out;
    out.depth = r.depth * m.height_scale;
    out.level = 1 - r.bias;
    out.holds_depth = r.holds_depth;
    out.max_steps = steps(r.max_steps, 1);
    out.min_steps = std::min(steps(r.min_steps, 1), out.max_steps);
    out.refinement_steps = std::min(steps(r.refinement_steps, 0), 32);
    out.self_shadow = r.self_shadow && bump != Bump::height;
    out.limit_silhouette = r.limit_silhouette && bump != Bump::height;
    set_scales(uv_matrix(m.height_texture.transform), tangent_matrix(m), aspect, out);
    return out;
}

FogFactors fog_factors(const Fog& fog) {
    FogFactors out{};
    out.kind = fog_number(fog.kind);
    out.color[0] = fog.color.x, out.color[1] = fog.color.y, out.color[2] = fog.color.z;
    out.start = fog.start, out.end = fog.end, out.density = fog.density;
    return out;
}

float mask_cutoff(const MaterialFactors& material, bool limits_silhouette) {
    return material.alpha_cutoff >= 0 || !limits_silhouette ? material.alpha_cutoff : 0.5f;
}

bool is_lit_per_face(const DrawList& list, const Draw& draw, Shading shading) {
    return shading == Shading::flat || list.scene.meshes[draw.mesh].normals.empty();
}

Culling culling_of(const DrawList& list, const Draw& draw, const RenderSettings& settings) {
    const CulledSides sides = culled_sides(settings.cull, list.material(draw).two_sided);
    // With y down a counter-clockwise triangle has negative area; a mirroring placement turns it round once more.
    return {sides.back, sides.front, (settings.front_face == FrontFace::counter_clockwise) != draw.mirrored};
}

bool has_ambient_light(const Scene& scene) {
    return std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) {
        return light.units == LightUnits::classical && light.ambient != vec3{0, 0, 0};
    });
}

}  // namespace rakelight::shading
