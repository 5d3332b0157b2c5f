// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/material_jobs.h"

#include "cpu_shading/make_material_job.h"
#include "shading/choices.h"
#include "shading/draw_choices.h"

namespace rakelight::raster {
Lighting lighting_of(const FrontEnd& front, std::uint32_t draw) {
    return shading::lighting_of(front.list, front.list.draws[draw], front.settings);
}

Bump bump_of(const FrontEnd& front, std::uint32_t draw) {
    return shading::bump_of(front.list, front.list.draws[draw], front.settings);
}

void make_material_jobs(FrontEnd& front, const PictureEffects& effects) {
    front.memory.add(front.list.draws.size() * sizeof(MaterialJob));
    front.shadows = effects.shadows;
    front.jobs.clear();
    front.jobs.reserve(front.list.draws.size());
    for (const Draw& draw : front.list.draws) {
        front.jobs.push_back(cpu_shading::make_material_job(front.list, front.list.views, draw, front.settings,
                                                            front.view, effects.is_explained));
        front.jobs.back().behind = effects.behind;
    }
}

ShadeJob draw_job(const FrontEnd& front, const std::vector<lighting::LightParameters>& lights, std::uint32_t draw) {
    ShadeJob out{};
    static_cast<MaterialJob&>(out) = front.jobs[draw];
    out.lights = lights.data();
    out.light_count = std::int32_t(lights.size());
    const Shading shading = front.shading[draw];
    if (shading == Shading::unlit) out.unlit = 1;
    if (shading == Shading::flat || shading == Shading::gouraud) out.bump = 0;
    out.shadows = front.shadows;
    out.affine = is_affine(front);
    out.kernel = cpu_shading::kernel_for(out, out.shadows != nullptr);
    return out;
}

bool wants_corner_frames(const FrontEnd& front, std::uint32_t draw) {
    const MaterialJob& job = front.jobs[draw];
    return job.has_bumps && (job.has_bitangents || job.tangent_space == shading::space_vertex ||
                             job.tangent_space == shading::space_transposed);
}

float mask_cutoff(const FrontEnd& front, std::uint32_t draw) {
    return shading::mask_cutoff(front.list.view(draw), front.jobs[draw].relief.limit_silhouette);
}

}  // namespace rakelight::raster
