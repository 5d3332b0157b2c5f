// SPDX-License-Identifier: Apache-2.0
#include "cpu_shading/make_material_job.h"

#include "scene/materials/material_conversion.h"
#include "shading/behind.h"
#include "shading/choices.h"
#include "shading/draw_choices.h"

namespace rakelight::cpu_shading {
namespace {

/// Width by height of the height map.
double height_aspect(const MaterialView& material) {
    const TextureView* const map = material.map[role_height].view;
    return map ? double(map->width[0]) / map->height[0] : 1;
}

void set_lighting(const Material& m, const RenderSettings& s, Lighting lighting, MaterialJob& out) {
    out.reflection_model = shading::reflection_model(lighting);
    out.reflection_form = shading::reflection_form(specular_form_of(m, s.specular_form));
    out.specular_horizon = s.specular_horizon;
    out.ward_form = shading::ward_number(shading::ward_form_of(m, s.ward_form));
    out.multiple_scattering = s.multiple_scattering;
    out.albedo = lighting::albedo_tables();
}

void set_bumps(const Material& m, const RenderSettings& s, Bump bump, MaterialJob& out) {
    out.bump = out.has_bumps = bump != Bump::none;
    out.bump_terms = shading::bump_terms_number(shading::bump_terms_of(m, s.bump_terms));
    out.tangent_space = shading::tangent_space_number(s.tangent_space);
    out.orthogonalize = s.orthogonalize;
    out.normalize_frames = s.normalize_frames;
    out.green_down = m.green_down, out.centered_normals = m.centered_normals;
}

void set_viewer(const shading::PictureCamera& view, const RenderSettings& s, MaterialJob& out) {
    out.orthographic = view.orthographic;
    out.viewer_at_infinity = s.viewer_at_infinity;
    const dvec3 back = view.camera_to_world[2].xyz();
    out.view_direction[0] = float(back.x), out.view_direction[1] = float(back.y), out.view_direction[2] = float(back.z);
}

/// Bumps beyond normal maps that act in the world as they are.
bool has_bump_choices(const MaterialJob& job) {
    return job.relief.technique != shading::relief_none ||
           (job.has_bumps && (job.bump_terms != shading::bump_both || job.tangent_space != shading::space_world ||
                              !job.normalize_frames || job.green_down || job.centered_normals || job.has_bitangents));
}

/// Lambert has no highlight: under it metals show their base color as diffuse.
bool is_metal_by_lambert(const MaterialJob& job) {
    return job.reflection_model == shading::reflects_lambert && job.material->metallic_roughness &&
           job.material->metallic > 0;
}

}  // namespace

MaterialJob make_material_job(const shading::DrawList& list, const MaterialViews& views, const shading::Draw& draw,
                              const RenderSettings& settings, const shading::PictureCamera& view, bool is_explained) {
    const Material& m = list.scene_material(list.material(draw));
    MaterialJob out{};
    out.material = &views.materials[draw.material];
    out.unlit = out.material->unlit;
    out.anisotropy = settings.anisotropy;
    set_lighting(m, settings, shading::lighting_of(list, draw, settings), out);
    set_bumps(m, settings, shading::bump_of(list, draw, settings), out);
    out.has_bitangents = out.has_bumps && out.material->map[role_normal].view != nullptr &&
                         !list.scene.meshes[draw.mesh].bitangents.empty();
    set_viewer(view, settings, out);
    out.relief = shading::relief_of(list, draw, settings, height_aspect(*out.material));
    if (views.environment && list.scene.environment->is_light) out.environment = &views.environment_view;
    out.has_light_around = is_explained || out.environment != nullptr || shading::has_ambient_light(list.scene);
    out.thickness_scale = shading::thickness_scale(draw);
    out.fog = shading::fog_factors(list.scene.fog);
    return out;
}

KernelNumber kernel_for(const MaterialJob& job, bool has_shadows) {
    if (job.fog.kind != shading::fog_none || has_bump_choices(job) || job.material->has_float_maps) return kernel_every;
    if (job.reflection_model == shading::reflects_pbr) {
        if (job.multiple_scattering || shading::has_layers(*job.material)) return kernel_every;
        return job.environment ? kernel_pbr_environment : kernel_pbr;
    }
    const bool is_classical =
        !has_shadows && job.reflection_model <= shading::reflects_blinn_phong && !is_metal_by_lambert(job);
    return is_classical && !job.environment ? kernel_classical : kernel_every;
}

float mean_roughness(const MaterialView& m) {
    const TextureView* const t = m.map[role_metallic_roughness].view;
    if (!t) return m.roughness;
    const std::int32_t last = t->levels - 1, width = t->width[last], height = t->height[last];
    float sum = 0;
    for (std::int32_t y = 0; y < height; ++y)
        for (std::int32_t x = 0; x < width; ++x) {
            const std::ptrdiff_t i = t->origin[last] + std::ptrdiff_t(y) * (width + 2) + x;
            sum += t->rgba32f ? t->rgba32f[4 * i + 1] : float(t->rgba8[i] >> 8 & 255u) * (1.0f / 255.0f);
        }
    return m.roughness * (sum / (float(width) * float(height)));
}

}  // namespace rakelight::cpu_shading
