// SPDX-License-Identifier: Apache-2.0
#include "document.h"

#include <algorithm>
#include <cmath>

#include <rakelight/math/linear.h>
#include <rakelight/render/shot.h>

namespace rakelight::viewer {

PictureRequest request_of(const Look& look, int width, int height) {
    PictureRequest request = look.request;
    request.settings.width = width;
    request.settings.height = height;
    request.settings.window = {};
    request.settings.channels = 0;
    if (request.motion.is_set() && look.time_s) request.motion.time_s = look.time_s;
    if (request.motion.is_set()) request.settings.shader_time_s = request.motion.time_s.value_or(0);
    if (look.eye) place(request.view, *look.eye, look.world_up);
    if (look.lights) {
        request.default_lights = request.studio_lights = false;
        request.lights.emplace();
        for (const LightItem& item : *look.lights)
            if (item.is_on) request.lights->push_back(item.light);
    }
    return request;
}

std::vector<ClipTime> clips_of(const Look& look, const Model& model) {
    MotionRequest motion = look.request.motion;
    if (motion.is_set() && look.time_s) motion.time_s = look.time_s;
    return rakelight::clips_of(model.scene, motion);
}

Camera camera_of(const Look& look, const Model& model, int width, int height) {
    return model.box.camera(model.scene, request_of(look, width, height).view, double(width) / double(height),
                            clips_of(look, model), look.request.settings.visibility);
}

Camera quick_camera_of(const Look& look, const Model& model, int width, int height) {
    return model.box.quick_camera(model.scene, request_of(look, width, height).view, double(width) / double(height),
                                  clips_of(look, model), look.request.settings.visibility);
}

Eye seen_eye(const Look& look, const Model& model, int width, int height) {
    return look.eye ? *look.eye : eye_of(quick_camera_of(look, model, width, height), model.box.bounds());
}

Eye& moving_eye(Look& look, const Model& model, int width, int height) {
    if (!look.eye) look.eye = seen_eye(look, model, width, height);
    return *look.eye;
}

bool set_eye(Look& look, const Eye& eye, const Model& model, int width, int height) {
    Look moved = look;
    moved.eye = eye;
    try {
        quick_camera_of(moved, model, width, height);
    } catch (const Error&) {
        return false;
    }
    look.eye = eye;
    return true;
}

std::optional<std::size_t> current_camera(const Look& look, const Model& model) {
    const ViewRequest& view = look.request.view;
    const std::vector<std::string>& cameras = model.box.cameras();
    if (look.eye || view.is_placed() || cameras.empty()) return {};
    if (!view.side.empty() && view.side != "file") return {};
    if (view.camera.empty()) return 0;
    for (std::size_t i = 0; i < cameras.size(); ++i)
        if (view.camera == std::to_string(i) || view.camera == cameras[i]) return i;
    return {};
}

std::vector<LightItem>& changing_lights(Look& look, const Model& model, int width, int height) {
    if (look.lights) return *look.lights;
    Scene lit;  // what requested_lights() looks at
    lit.lights = model.box.lights(clips_of(look, model));
    lit.environment = model.scene.environment;
    PictureRequest request = request_of(look, width, height);
    request.light_intensity = 1;  // stays a setting of its own
    request.light_cutoff = 0;
    request.materials = {};
    request.hdri_file.clear();  // whether an environment gives light does not depend on its picture
    Context quiet({.threads = 1});
    lit = as_requested(std::move(lit), request, quiet);
    look.lights.emplace();
    for (Light& light : requested_lights(lit, request, quick_camera_of(look, model, width, height)))
        look.lights->push_back({.light = std::move(light)});
    return *look.lights;
}

void carry_lights(Look& look, const Camera& from, const Camera& to) {
    dmat4 back;
    if (!look.lights || from.to_world == to.to_world || !inverse_affine(from.to_world, back)) return;
    const dmat4 move = to.to_world * back;
    for (LightItem& item : *look.lights) {
        if (!item.follows_camera) continue;
        item.light.position = transform_point(move, item.light.position);
        item.light.direction = normalize_or(transform_direction(move, item.light.direction), dvec3{0, 0, -1});
    }
}

std::vector<std::string> files_of(const Look& look) {
    std::vector<std::string> files;
    const MaterialOverrides& all = look.request.materials;
    for (const std::string* file : {&look.request.hdri_file, &all.base_color, &all.normal, &all.height})
        if (!file->empty()) files.push_back(*file);
    const auto add = [&](const std::vector<WorldValue>& values) {
        for (const WorldValue& value : values)
            if (value.key.ends_with("_texture") && !value.words.empty()) files.push_back(value.words[0]);
    };
    add(all.values);
    for (const MaterialEdit& edit : look.materials) add(edit.values);
    return files;
}

/// An up direction across the view, as that of a rolled picture (see place()), says nothing of the world.
dvec3 world_up_of(const ViewRequest& view) {
    constexpr dvec3 usual{0, 1, 0};
    if (view.world_up) return normalize_or(*view.world_up, usual);
    if (!view.up) return usual;
    const dvec3 up = normalize_or(*view.up, usual);
    const bool is_axis = std::max({std::fabs(up.x), std::fabs(up.y), std::fabs(up.z)}) == 1;
    if (is_axis || !view.position || !view.focal_point) return up;
    const dvec3 ahead = normalize_or(*view.focal_point - *view.position, dvec3{0, 0, 0});
    return std::fabs(dot(up, ahead)) < 1e-6 ? usual : up;
}

Look first_look(const Model& model) {
    const PictureRequest& request = model.request;
    const bool says_shadows = std::ranges::find(request.given_keys, "shadows") != request.given_keys.end();
    return {.request = request,
            .world_up = world_up_of(request.view),
            .shadows_by_nature = request.engine == "trace" && request.settings.shadows && !says_shadows};
}

}  // namespace rakelight::viewer
