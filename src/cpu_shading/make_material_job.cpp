// SPDX-License-Identifier: Apache-2.0
#include "cpu_shading/make_material_job.h"

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

void set_viewer(const shading::View& view, const RenderSettings& s, MaterialJob& out) {
    out.orthographic = view.orthographic;
    out.viewer_at_infinity = s.viewer_at_infinity;
    const dvec3 back = view.camera_to_world[2].xyz();
    out.view_direction[0] = float(back.x), out.view_direction[1] = float(back.y), out.view_direction[2] = float(back.z);
}

}  // namespace

MaterialJob make_material_job(const shading::DrawList& list, const MaterialViews& views, const shading::Draw& draw,
                              const RenderSettings& settings, const shading::View& view, bool is_explained) {
    const Material& m = list.scene_material(list.material(draw));
    MaterialJob out{};
    out.material = &views.materials[draw.material];
    out.unlit = out.material->unlit;
    out.anisotropy = settings.anisotropy;
    set_lighting(m, settings, shading::lighting_of(list, draw, settings), out);
    set_bumps(m, settings, shading::bump_of(list, draw, settings), out);
    set_viewer(view, settings, out);
    out.relief = shading::relief_of(list, draw, settings, height_aspect(*out.material));
    if (views.environment && list.scene.environment->is_light) out.environment = &views.environment_view;
    out.has_light_around = is_explained || out.environment != nullptr || shading::has_ambient_light(list.scene);
    out.fog = shading::fog_factors(list.scene.fog);
    return out;
}

}  // namespace rakelight::cpu_shading
