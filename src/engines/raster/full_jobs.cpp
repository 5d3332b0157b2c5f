// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/full_jobs.h"

#include "shading/choices.h"
#include "shading/draw_choices.h"

namespace rakelight::raster {
namespace {

/// Width by height of the height map.
double height_aspect(const MaterialView& material) {
    const TextureView* const map = material.map[role_height].view;
    return map ? double(map->width[0]) / map->height[0] : 1;
}

FullJob full_job(const FrontEnd& front, std::uint32_t draw, const PictureEffects& effects) {
    const RenderSettings& s = front.settings;
    const Material& m = front.list.scene_material(front.list.material(front.list.draws[draw]));
    FullJob out{};
    out.ward_form = shading::ward_number(shading::ward_form_of(m, s.ward_form));
    out.multiple_scattering = s.multiple_scattering;
    out.viewer_at_infinity = s.viewer_at_infinity;
    out.bump_terms = shading::bump_terms_number(shading::bump_terms_of(m, s.bump_terms));
    out.tangent_space = shading::tangent_space_number(s.tangent_space);
    out.has_bumps = bump_of(front, draw) != Bump::none;
    out.normalize_frames = s.normalize_frames;
    out.green_down = m.green_down, out.centered_normals = m.centered_normals;
    out.relief = shading::relief_of(front.list, front.list.draws[draw], s, height_aspect(front.list.view(draw)));
    out.shadows = effects.shadows;
    const std::optional<Environment>& environment = front.list.scene.environment;
    if (front.list.environment && environment->is_light) out.environment = &front.list.environment_view;
    out.has_light_around =
        effects.is_explained || out.environment != nullptr || shading::has_ambient_light(front.list.scene);
    out.fog = shading::fog_factors(front.list.scene.fog);
    out.albedo = lighting::albedo_tables();
    return out;
}

/// Lambert has no highlight: under it metals show their base color as diffuse, which the plain kernel does not know.
bool is_metal_by_lambert(const FrontEnd& front, std::uint32_t draw) {
    const MaterialView& m = front.list.view(draw);
    return lighting_of(front, draw) == Lighting::lambert && m.metallic_roughness && m.metallic > 0;
}

/// The plain kernel has Lambert, Phong and Blinn-Phong.
bool is_beyond_plain(Lighting lighting) {
    return lighting != Lighting::lambert && lighting != Lighting::phong && lighting != Lighting::blinn_phong;
}

bool needs_full(const FrontEnd& front, std::uint32_t draw, const FullJob& job) {
    return is_beyond_plain(lighting_of(front, draw)) || is_metal_by_lambert(front, draw) || job.viewer_at_infinity ||
           job.relief.technique != relief_none || job.shadows || job.environment || job.fog.kind != 0 ||
           (job.has_bumps && (job.bump_terms != bump_both || job.tangent_space != space_world ||
                              !job.normalize_frames || job.green_down || job.centered_normals));
}

}  // namespace

Lighting lighting_of(const FrontEnd& front, std::uint32_t draw) {
    return shading::lighting_of(front.list, front.list.draws[draw], front.settings);
}

Bump bump_of(const FrontEnd& front, std::uint32_t draw) {
    return shading::bump_of(front.list, front.list.draws[draw], front.settings);
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
    if (front.full.empty() || !front.full[draw].has_bumps) return false;
    const std::int32_t space = front.full[draw].tangent_space;
    return space == space_vertex || space == space_transposed;
}

float mask_cutoff(const FrontEnd& front, std::uint32_t draw) {
    const bool limits_silhouette = !front.full.empty() && front.full[draw].relief.limit_silhouette;
    return shading::mask_cutoff(front.list.view(draw), limits_silhouette);
}

}  // namespace rakelight::raster
