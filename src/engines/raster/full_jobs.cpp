// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/full_jobs.h"

#include <algorithm>

namespace rakelight::raster {
namespace {

void copy(float (&to)[3], vec3 from) { to[0] = from.x, to[1] = from.y, to[2] = from.z; }

bool reads_heights(Bump bump) { return bump != Bump::none && bump != Bump::normal && bump != Bump::displacement; }

ReliefView relief_view(const Relief& r, Bump bump) {
    return {reads_heights(bump) ? std::int32_t(bump) : 0,
            r.depth,
            r.bias,
            r.holds_depth,
            r.min_steps,
            r.max_steps,
            r.refinement_steps,
            r.self_shadow,
            r.limit_silhouette};
}

FogView fog_view(const Fog& fog) {
    FogView out{};
    out.kind = std::int32_t(fog.kind);
    copy(out.color, fog.color);
    out.start = fog.start, out.end = fog.end, out.density = fog.density;
    return out;
}

FullJob full_job(const FrontEnd& front, std::uint32_t draw, const PictureEffects& effects) {
    const RenderSettings& s = front.settings;
    const Material& m = material_of(front, draw);
    const BumpTerms terms = m.bump_terms == BumpTerms::automatic ? s.bump_terms : m.bump_terms;
    FullJob out{};
    out.ward_form = std::int32_t(m.ward_form.value_or(s.ward_form));
    out.multiple_scattering = s.multiple_scattering;
    out.viewer_at_infinity = s.viewer_at_infinity;
    out.bump_terms = terms == BumpTerms::diffuse ? 1 : terms == BumpTerms::specular ? 2 : 0;
    out.tangent_space = std::int32_t(s.tangent_space);
    out.normalize_frames = s.normalize_frames;
    out.green_down = m.green_down, out.centered_normals = m.centered_normals;
    out.relief = relief_view(m.relief.value_or(s.relief), bump_of(front, draw));
    if (!effects.shadows.empty()) out.shadows = effects.shadows.data();
    out.environment = effects.environment;
    out.fog = fog_view(front.list.scene.fog);
    return out;
}

bool needs_full(const FrontEnd& front, std::uint32_t draw, const FullJob& job) {
    const bool bumps = bump_of(front, draw) != Bump::none;
    return lighting_of(front, draw) > Lighting::blinn_phong || job.viewer_at_infinity || job.relief.technique != 0 ||
           job.shadows || job.environment || job.fog.kind != 0 ||
           (bumps && (job.bump_terms != 0 || job.tangent_space != 0 || !job.normalize_frames || job.green_down ||
                      job.centered_normals));
}

}  // namespace

const Material& material_of(const FrontEnd& front, std::uint32_t draw) {
    static const Material otherwise;
    const std::uint32_t i = front.list.materials[front.list.draws[draw].material].scene_material;
    return i == none ? otherwise : front.list.scene.materials[i];
}

Lighting lighting_of(const FrontEnd& front, std::uint32_t draw) {
    const Lighting own = material_of(front, draw).lighting;
    const Lighting wanted = own == Lighting::automatic ? front.settings.lighting : own;
    return wanted == Lighting::automatic ? Lighting::blinn_phong : wanted;
}

Bump bump_of(const FrontEnd& front, std::uint32_t draw) {
    const Material& m = material_of(front, draw);
    const Bump wanted = m.bump == Bump::automatic ? front.settings.bump : m.bump;
    if (wanted != Bump::automatic) return wanted;
    return m.normal_texture ? Bump::normal : m.height_texture ? Bump::height : Bump::none;
}

void make_full_jobs(FrontEnd& front, const PictureEffects& effects) {
    const auto draws = std::uint32_t(front.list.draws.size());
    std::vector<FullJob> jobs(draws);
    front.needs_full.assign(draws, 0);
    for (std::uint32_t d = 0; d < draws; ++d) {
        jobs[d] = full_job(front, d, effects);
        front.needs_full[d] = needs_full(front, d, jobs[d]);
    }
    const bool any =
        std::any_of(front.needs_full.begin(), front.needs_full.end(), [](std::uint8_t n) { return n != 0; });
    front.full = any ? std::move(jobs) : std::vector<FullJob>();
}

}  // namespace rakelight::raster
