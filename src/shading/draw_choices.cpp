// SPDX-License-Identifier: Apache-2.0
#include "shading/draw_choices.h"

#include <algorithm>
#include <cmath>

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
void set_scales(const UvTransform& map, double aspect, ReliefFactors& out) {
    const double along_u = std::sqrt(double(map.uu) * map.uu + double(map.vu) * map.vu);
    const double along_v = std::sqrt(double(map.uv) * map.uv + double(map.vv) * map.vv);
    out.to_uv[0] = along_u > 0 ? float(1 / along_u) : 0;
    out.to_uv[1] = along_v > 0 ? float(-aspect / along_v) : 0;
    out.to_map[0][0] = map.uu * out.to_uv[0], out.to_map[0][1] = map.uv * out.to_uv[1];
    out.to_map[1][0] = map.vu * out.to_uv[0], out.to_map[1][1] = map.vv * out.to_uv[1];
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
    set_scales(uv_transform(texture_roles()[role_height].in(m)), aspect, out);
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
