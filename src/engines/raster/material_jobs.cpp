// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/material_jobs.h"

#include "cpu_shading/make_material_job.h"
#include "shading/choices.h"
#include "shading/draw_choices.h"

namespace rakelight::raster {
namespace {

/// Bumps beyond normal maps that act in the world as they are.
bool has_bump_choices(const MaterialJob& job) {
    return job.relief.technique != shading::relief_none ||
           (job.has_bumps && (job.bump_terms != shading::bump_both || job.tangent_space != shading::space_world ||
                              !job.normalize_frames || job.green_down || job.centered_normals));
}

/// Lambert has no highlight: under it metals show their base color as diffuse.
bool is_metal_by_lambert(const MaterialJob& job) {
    return job.reflection_model == shading::reflects_lambert && job.material->metallic_roughness &&
           job.material->metallic > 0;
}

/// The kernel that leaves out most of what a job does not ask for.
KernelNumber kernel_for(const MaterialJob& job, const ShadowView* shadows) {
    if (job.fog.kind != shading::fog_none || has_bump_choices(job) || job.material->has_float_maps) return kernel_every;
    if (job.reflection_model == shading::reflects_pbr) {
        if (job.multiple_scattering || shading::has_layers(*job.material)) return kernel_every;
        return job.environment ? kernel_pbr_environment : kernel_pbr;
    }
    const bool is_classical =
        !shadows && job.reflection_model <= shading::reflects_blinn_phong && !is_metal_by_lambert(job);
    return is_classical && !job.environment ? kernel_classical : kernel_every;
}

}  // namespace

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
    for (const Draw& draw : front.list.draws)
        front.jobs.push_back(cpu_shading::make_material_job(front.list, front.list.views, draw, front.settings,
                                                            front.view, effects.is_explained));
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
    out.kernel = kernel_for(out, out.shadows);
    return out;
}

bool wants_corner_frames(const FrontEnd& front, std::uint32_t draw) {
    const MaterialJob& job = front.jobs[draw];
    return job.has_bumps &&
           (job.tangent_space == shading::space_vertex || job.tangent_space == shading::space_transposed);
}

float mask_cutoff(const FrontEnd& front, std::uint32_t draw) {
    return shading::mask_cutoff(front.list.view(draw), front.jobs[draw].relief.limit_silhouette);
}

}  // namespace rakelight::raster
