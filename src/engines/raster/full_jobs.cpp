// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/full_jobs.h"

#include <algorithm>
#include <cmath>

#include "scene/material_table.h"
#include "scene/scene_tools.h"
#include "shading/choices.h"

namespace rakelight::raster {
namespace {

void copy(float (&to)[3], vec3 from) { to[0] = from.x, to[1] = from.y, to[2] = from.z; }

bool has_coordinates(const Mesh& mesh, const TextureSlot& slot) {
    return slot.view && rakelight::has_coordinates(mesh, std::uint32_t(slot.texcoord_set));
}

/// Steps of a march: what a file says, within what a picture can be waited for.
std::int32_t steps(int wanted, int least) { return std::clamp(wanted, least, 1024); }

/// What one width of the texture along tangent and bitangent is in texture coordinates. Texels are taken as square on
/// the surface, as normal maps take them. v counts down, the bitangent points up.
void set_scales(const TextureSlot& map, ReliefView& out) {
    const double along_u = std::sqrt(double(map.uu) * map.uu + double(map.vu) * map.vu);
    const double along_v = std::sqrt(double(map.uv) * map.uv + double(map.vv) * map.vv);
    const double aspect = double(map.view->width[0]) / map.view->height[0];
    out.to_uv[0] = along_u > 0 ? float(1 / along_u) : 0;
    out.to_uv[1] = along_v > 0 ? float(-aspect / along_v) : 0;
    out.to_map[0][0] = map.uu * out.to_uv[0], out.to_map[0][1] = map.uv * out.to_uv[1];
    out.to_map[1][0] = map.vu * out.to_uv[0], out.to_map[1][1] = map.vv * out.to_uv[1];
}

ReliefView relief_view(const Relief& r, Bump bump, float scale, const TextureSlot& map) {
    ReliefView out{};
    out.technique = shading::relief_technique(bump);
    if (out.technique == relief_none) return out;
    out.depth = r.depth * scale;
    out.level = 1 - r.bias;
    out.holds_depth = r.holds_depth;
    out.max_steps = steps(r.max_steps, 1);
    out.min_steps = std::min(steps(r.min_steps, 1), out.max_steps);
    out.refinement_steps = std::min(steps(r.refinement_steps, 0), 32);
    out.self_shadow = r.self_shadow && bump != Bump::height;
    out.limit_silhouette = r.limit_silhouette && bump != Bump::height;
    set_scales(map, out);
    return out;
}

FogView fog_view(const Fog& fog) {
    FogView out{};
    out.kind = shading::fog_number(fog.kind);
    copy(out.color, fog.color);
    out.start = fog.start, out.end = fog.end, out.density = fog.density;
    return out;
}

bool has_ambient_light(const FrontEnd& front) {
    const std::vector<Light>& lights = front.list.scene.lights;
    return std::any_of(lights.begin(), lights.end(), [](const Light& light) {
        return light.units == LightUnits::classical && light.ambient != vec3{0, 0, 0};
    });
}

FullJob full_job(const FrontEnd& front, std::uint32_t draw, const PictureEffects& effects) {
    const RenderSettings& s = front.settings;
    const Material& m = material_of(front, draw);
    const MaterialView& view = front.list.materials[front.list.draws[draw].material].view;
    FullJob out{};
    out.ward_form = shading::ward_number(m.ward_form.value_or(s.ward_form));
    out.multiple_scattering = s.multiple_scattering;
    out.viewer_at_infinity = s.viewer_at_infinity;
    out.bump_terms = shading::bump_terms_number(shading::bump_terms_of(m, s.bump_terms));
    out.tangent_space = std::int32_t(s.tangent_space);
    out.has_bumps = bump_of(front, draw) != Bump::none;
    out.normalize_frames = s.normalize_frames;
    out.green_down = m.green_down, out.centered_normals = m.centered_normals;
    out.relief = relief_view(m.relief.value_or(s.relief), bump_of(front, draw), m.height_scale, view.map[role_height]);
    out.shadows = effects.shadows;
    const std::optional<Environment>& environment = front.list.scene.environment;
    if (front.list.environment && environment->is_light) out.environment = &front.list.environment_view;
    out.has_light_around = effects.is_explained || out.environment != nullptr || has_ambient_light(front);
    out.fog = fog_view(front.list.scene.fog);
    out.albedo = lighting::albedo_tables();
    return out;
}

/// Lambert has no highlight: under it metals show their base color as diffuse, which the plain kernel does not know.
bool is_metal_by_lambert(const FrontEnd& front, std::uint32_t draw) {
    const Material& m = material_of(front, draw);
    return lighting_of(front, draw) == Lighting::lambert && m.model == MaterialModel::metallic_roughness &&
           m.metallic_roughness.metallic > 0;
}

/// The plain kernel has Lambert, Phong and Blinn-Phong.
bool is_beyond_plain(Lighting lighting) {
    return lighting != Lighting::lambert && lighting != Lighting::phong && lighting != Lighting::blinn_phong;
}

bool needs_full(const FrontEnd& front, std::uint32_t draw, const FullJob& job) {
    return is_beyond_plain(lighting_of(front, draw)) || is_metal_by_lambert(front, draw) || job.viewer_at_infinity ||
           job.relief.technique != 0 || job.shadows || job.environment || job.fog.kind != 0 ||
           (job.has_bumps && (job.bump_terms != 0 || job.tangent_space != 0 || !job.normalize_frames ||
                              job.green_down || job.centered_normals));
}

}  // namespace

const Material& material_of(const FrontEnd& front, std::uint32_t draw) {
    static const Material otherwise;
    const std::uint32_t i = front.list.materials[front.list.draws[draw].material].scene_material;
    return i == none ? otherwise : front.list.scene.materials[i];
}

Lighting lighting_of(const FrontEnd& front, std::uint32_t draw) {
    return shading::lighting_of(material_of(front, draw), front.settings.lighting);
}

Bump bump_of(const FrontEnd& front, std::uint32_t draw) {
    const Bump wanted = bump_of(material_of(front, draw), front.settings.bump);
    if (wanted == Bump::none || wanted == Bump::displacement) return Bump::none;
    const Draw& d = front.list.draws[draw];
    const MaterialView& view = front.list.materials[d.material].view;
    const Mesh& mesh = front.list.scene.meshes[d.mesh];
    if (reads_heights(wanted) && has_coordinates(mesh, view.map[role_height])) return wanted;
    return has_coordinates(mesh, view.map[role_normal]) ? Bump::normal : Bump::none;
}

void make_full_jobs(FrontEnd& front, const PictureEffects& effects) {
    const auto draws = std::uint32_t(front.list.draws.size());
    front.full.clear();  // none until one is needed: most pictures need none
    front.needs_full.assign(draws, 0);
    for (std::uint32_t d = 0; d < draws; ++d) {
        const FullJob job = full_job(front, d, effects);
        front.needs_full[d] = needs_full(front, d, job);
        if (front.needs_full[d] != 0 && front.full.empty()) {
            front.memory.add(draws * sizeof(FullJob));
            front.full.resize(draws);
            for (std::uint32_t before = 0; before < d; ++before) front.full[before] = full_job(front, before, effects);
        }
        if (!front.full.empty()) front.full[d] = job;
    }
}

bool wants_corner_frames(const FrontEnd& front, std::uint32_t draw) {
    return !front.full.empty() && front.full[draw].tangent_space >= std::int32_t(TangentSpace::vertex) &&
           front.full[draw].has_bumps;
}

float mask_cutoff(const FrontEnd& front, std::uint32_t draw) {
    const MaterialView& view = front.list.materials[front.list.draws[draw].material].view;
    const bool is_limited = !front.full.empty() && front.full[draw].relief.limit_silhouette;
    return view.alpha_cutoff >= 0 || !is_limited ? view.alpha_cutoff : 0.5f;
}

}  // namespace rakelight::raster
