// SPDX-License-Identifier: Apache-2.0
#include "render/lit_scenes.h"

#include <rakelight/base/report.h>

#include <algorithm>
#include <cstdio>

#include "scene/drawn_vertices.h"
#include "scene/fitted_camera.h"

namespace rakelight {

void add_note(const RadiosityReport& r, const std::string& file, Report& report) {
    const double whole = r.emitted > 0 ? 100 / r.emitted : 0;
    char text[240];
    std::snprintf(
        text, sizeof text,
        "radiosity: %u elements, %u patches, %u shots; of %.4g W %.1f %% are absorbed, %.1f %% unshot, %.1f %% "
        "left the scene",
        r.elements, r.patches, r.shots, r.emitted, whole * r.absorbed, whole * r.unshot,
        std::max(0.0, whole * r.escaped));
    report.add(Remark::note, file, "", text, {"method"});
}

Scene lit_by_radiosity(Scene posed, const RadiositySettings& settings, RadiosityReport& report, Context& context) {
    Scene out = with_radiosity(std::move(posed), settings, report, context);
    add_note(report, out.source, context.report());
    return out;
}

std::shared_ptr<PreparedScene> lit_by_radiosity(const PreparedScene& prepared,
                                                const std::optional<std::vector<Light>>& lights,
                                                const RadiositySettings& settings, Context& context) {
    Scene scene = prepared.posed(context);
    scene.lights = lights ? *lights : lights_of(scene, default_camera(DrawnVertices(scene), 1), RayMethod::radiosity);
    RadiosityReport report;
    auto out = std::make_shared<PreparedScene>();
    out->scene = lit_by_radiosity(std::move(scene), settings, report, context);
    out->options = prepared.options;
    return out;
}

std::shared_ptr<const PreparedScene> LitScenes::of(const std::shared_ptr<const PreparedScene>& prepared,
                                                   const std::optional<std::vector<Light>>& lights,
                                                   const RadiositySettings& settings, Context& context) {
    const std::vector<Light>& own = prepared->scene.lights;
    if (lit_ && are_drawn_alike(*prepared, *prepared_) && settings == settings_ && lights == lights_ &&
        own == own_lights_)
        return lit_;
    lit_.reset();
    std::shared_ptr<const PreparedScene> lit = lit_by_radiosity(*prepared, lights, settings, context);
    prepared_ = prepared, lights_ = lights, own_lights_ = own, settings_ = settings;
    return lit_ = std::move(lit);
}

}  // namespace rakelight
