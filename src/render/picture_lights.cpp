// SPDX-License-Identifier: Apache-2.0
#include "render/picture_lights.h"

#include <rakelight/base/report.h>
#include <rakelight/math/linear.h>
#include <rakelight/render/shot.h>
#include <rakelight/scene/scene_queries.h>
#include <rakelight_internal/base/text.h>

#include "base/format_text.h"
#include "render/prepared_scene.h"
#include "scene/light_cutoff.h"
#include "scene/validate.h"
#include "world/keys/fixed_function.h"

namespace rakelight {
namespace {

void scale_light(Light& light, float factor) {
    light.ambient = light.ambient * factor;
    light.diffuse = light.diffuse * factor;
    light.specular = light.specular * factor;
    light.intensity *= factor;
}

std::vector<Light> wanted_lights(const Scene& scene, const PictureRequest& request, const Camera& camera) {
    return request.lights           ? *request.lights
           : request.default_lights ? default_lights(camera.to_world)
           : request.studio_lights  ? studio_lights(camera.to_world)
                                    : lights_of(scene, camera, request.settings.method);
}

void note_lights_left_out(std::size_t count, const std::string& source, Report& report) {
    report.add(
        Remark::note, source, "",
        format_text("the preset has the first {} lights: {} left out", max_fixed_lights, counted(count, "is", "are")),
        {"preset"});
}

/// @param report  null: not wanted
std::vector<Light> chosen_lights(const Scene& scene, const PictureRequest& request, const Camera& camera,
                                 Report* report) {
    const std::vector<Light> wanted = wanted_lights(scene, request, camera);
    const std::size_t beyond = lights_beyond_preset(wanted, request);
    if (report && beyond > 0) note_lights_left_out(beyond, scene.source, *report);
    std::vector<Light> lights = within_preset(wanted, request);
    if (request.light_intensity != 1)
        for (Light& light : lights) scale_light(light, float(request.light_intensity));
    if (report) validate_lights(lights, scene.nodes.size());
    if (!(request.light_cutoff > 0)) return lights;
    const CutLights cut = cut_lights(lights, request.light_cutoff);
    if (report) report->add(Remark::note, scene.source, "", said(cut, request.light_cutoff));
    return lights;
}

}  // namespace

std::vector<Light> requested_lights(const Scene& scene, const PictureRequest& request, const Camera& camera) {
    return chosen_lights(scene, request, camera, nullptr);
}

std::optional<std::vector<Light>> lights_of_shot(const Scene& scene, const PictureRequest& request,
                                                 const Camera& camera, bool is_view, Report& report) {
    const bool is_default_rig = !request.lights && !request.default_lights && !request.studio_lights &&
                                request.light_intensity == 1 && request.light_cutoff == 0 && scene.lights.empty();
    if (is_view && is_default_rig && request.settings.method == RayMethod::radiosity) return {};
    return chosen_lights(scene, request, camera, &report);
}

}  // namespace rakelight
