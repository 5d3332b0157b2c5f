// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/paths/path_lights.h"

#include <algorithm>

#include "shading/environment.h"
#include "shading/lights/luminance.h"

namespace rakelight::raytrace {
namespace {

constexpr std::size_t most_lights_each = 8;  ///< asked by every point

double luminance(const float (&c)[3]) { return shading::luminance_of(vec3{c[0], c[1], c[2]}); }

/// The intensity of a light, without distance attenuation.
double power_of(const lighting::LightParameters& light) {
    const double power = light.is_photometric ? luminance(light.intensity)
                                              : std::max(luminance(light.diffuse), luminance(light.specular));
    const double falls = double(light.constant_term) + double(light.linear_term) + double(light.quadratic_term);
    return light.is_photometric || !(falls > 0) ? power : power / falls;
}

}  // namespace

std::unique_ptr<ScenePathLights> make_path_lights(const cpu_shading::DrawList& list,
                                                  const shading::TextureCache& textures, FrontFace front_face,
                                                  Context& context) {
    auto out = std::make_unique<ScenePathLights>();
    out->front_face = front_face;
    out->emitters = shading::Emitters(list, textures, front_face, context);
    if (list.views.environment && list.scene.environment->is_light)
        out->sky = shading::EnvironmentTable(shading::sky_of(*list.scene.environment, context), context);
    return out;
}

PathLights::PathLights(const ScenePathLights& scene, const TracePicture& picture)
    : scene_(scene), picture_(picture), eye_(picture.view.camera_to_world[3].xyz()) {
    const cpu_shading::DrawList& list = picture.list;
    has_sky_ = list.views.environment && list.scene.environment->is_light;
    if (picture.settings.paths.light_sampling != LightSampling::materials)
        choice_ = {has_sky_ && !scene.sky.empty() && list.scene.environment->intensity > 0, !scene.emitters.empty()};
    if (picture.lights.size() <= most_lights_each) return;
    std::vector<double> powers;
    for (const lighting::LightParameters& light : picture.lights) powers.push_back(power_of(light));
    picks_ = shading::AliasTable(powers);
    if (picks_.empty()) return;
    for (std::uint32_t i = 0; i < picture.lights.size(); ++i) {
        const float probability = picks_.probability(i);
        light_scale_.push_back(probability > 0 ? 1 / (float(most_picked_lights) * probability) : 0.0f);
    }
}

ChosenEmitter PathLights::choose(const std::array<std::uint32_t, 4>& numbers) const {
    ChosenEmitter out;
    if (!is_there()) return out;
    const shading::LightChoice::Pick pick = choice_.pick(unit_double(numbers[0]));
    if (pick.is_environment) {
        const shading::EnvironmentTable::Sample s = scene_.sky.sample({pick.rest, unit_double(numbers[1])});
        out.place = shading::from_picture(picture_.list.views.environment_view, s.direction);
        out.density = s.pdf * float(pick.probability), out.is_far = true;
        return out;
    }
    const vec2 u{unit_float(numbers[1]), unit_float(numbers[2])};
    const shading::EmitterSample s = scene_.emitters.sample(pick.rest, u, eye_);
    out.place = s.position, out.normal = s.normal, out.density = s.pdf_area * float(pick.probability);
    out.size = s.size;
    out.shines_back = s.shines_back, out.draw = s.draw, out.triangle = s.triangle;
    return out;
}

float PathLights::density_of_sky(vec3 direction) const {
    if (!choice_.has_environment) return 0;
    return float(choice_.probability_of_environment()) *
           scene_.sky.pdf(shading::to_picture(picture_.list.views.environment_view, direction));
}

}  // namespace rakelight::raytrace
