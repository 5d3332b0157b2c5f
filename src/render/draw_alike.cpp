// SPDX-License-Identifier: Apache-2.0
#include <rakelight/base/report.h>
#include <rakelight_internal/render/draw_alike.h>

#include <cmath>

#include <rakelight/io/world.h>
#include <rakelight/render/picture.h>
#include <rakelight/render/shot.h>

#include "math/functions.h"
#include "math/linear.h"
#include "prepare/pose_scene.h"
#include "render/asked_scenes.h"
#include "render/camera/camera_chooser.h"
#include "render/camera/camera_depths.h"
#include "render/look.h"
#include "render/picture.h"
#include "scene/merge_scenes.h"
#include "scene/placement.h"
#include "shading/lights/lights.h"
#include "world/coloring.h"
#include "world/z_up.h"

namespace rakelight {
namespace {

bool has_light(const Scene& scene) { return !scene.lights.empty() || scene.environment; }

bool states_up(const PictureRequest& request) { return names(request, "up") || request.view.world_up.has_value(); }

/// One up axis for both scenes, unless it is given.
void share_up(Scene& a, PictureRequest& of_a, Scene& b, PictureRequest& of_b, Report& report) {
    if (states_up(of_a) || states_up(of_b)) return;
    const std::optional<UpAxis> up = share_up_axis(a, b, report);
    if (!up) return;
    for (PictureRequest* const request : {&of_a, &of_b})
        if (!request->view.up) request->view.world_up = *up == UpAxis::z ? dvec3{0, 0, 1} : dvec3{0, 1, 0};
}

/// A scene without light gets that of the other one.
void share_light(Scene& to, const Scene& from) {
    if (has_light(to) || !has_light(from)) return;
    const std::vector<dmat4> world = world_matrices(with_posed_nodes(from));
    for (Light light : from.lights) {
        const shading::LightPlace place = shading::place_of(light, world);
        light.position = place.position, light.direction = place.direction, light.node = no_index;
        to.lights.push_back(std::move(light));
    }
    to.environment = from.environment;
    if (to.fog.kind == FogKind::none) to.fog = from.fog;
}

/// Both as one scene, for what is chosen for both. It has the lights of one side and the cameras of one side.
Scene both(const Scene& a, const Scene& b, Context& context) {
    const std::optional<Scene> posed_a = posed_outline(a, context), posed_b = posed_outline(b, context);
    const bool has_camera = !a.cameras.empty();
    const ScenePart parts[] = {{posed_a ? *posed_a : a, {}, true, has_camera},
                               {posed_b ? *posed_b : b, {}, false, !has_camera}};
    Scene all = merge_scenes(parts, context).scene;
    all.source = is_world_file(b.source) ? b.source : a.source;
    all.environment = a.environment ? a.environment : b.environment;
    all.fog = a.fog.kind != FogKind::none ? a.fog : b.fog;
    return all;
}

/// The settings that the look decides, besides light and camera. One that only one side gives holds for both.
struct SharedSetting {
    std::string_view key, other_key;
    void (*copy)(PictureRequest& to, const PictureRequest& from);
};
const SharedSetting shared_settings[] = {
    {"samples", "samples",
     [](PictureRequest& to, const PictureRequest& from) { to.settings.samples = from.settings.samples; }},
    {"shadows", "shadows",
     [](PictureRequest& to, const PictureRequest& from) { to.settings.shadows = from.settings.shadows; }},
    {"shadow-filter", "shadow-filter",
     [](PictureRequest& to, const PictureRequest& from) { to.settings.shadow_filter = from.settings.shadow_filter; }},
    {"background", "background",
     [](PictureRequest& to, const PictureRequest& from) { to.settings.background = from.settings.background; }},
    {"exposure", "tone-mapping", [](PictureRequest& to, const PictureRequest& from) { to.tone = from.tone; }},
    {"point-size", "point-size",
     [](PictureRequest& to, const PictureRequest& from) { to.settings.point_size = from.settings.point_size; }}};

bool is_given(const PictureRequest& request, const SharedSetting& setting) {
    return names(request, {setting.key, setting.other_key});
}

void take_given(PictureRequest& to, const PictureRequest& from) {
    for (const SharedSetting& setting : shared_settings) {
        if (is_given(to, setting) || !is_given(from, setting)) continue;
        setting.copy(to, from);
        to.given_keys.emplace_back(setting.key);
    }
}

/// @param from  with what its look has chosen
void follow(PictureRequest& to, const PictureRequest& from) {
    for (const SharedSetting& setting : shared_settings)
        if (!is_given(to, setting)) setting.copy(to, from);
}

bool is_free(const ViewRequest& view) { return view == ViewRequest{.world_up = view.world_up}; }

/// The view that is asked for; absent: each side asks for one of its own.
std::optional<ViewRequest> common_view(const ViewRequest& a, const ViewRequest& b) {
    if (a == b || is_free(b)) return a;
    if (is_free(a)) return b;
    return {};
}

/// A camera in the world as a request, which places it at the same point before any model.
ViewRequest view_through(const Camera& camera, const std::optional<dvec3>& world_up) {
    const bool is_parallel = camera.projection == Projection::orthographic;
    const dvec3 back = camera.to_world[2].xyz();
    ViewRequest view{.up = camera.to_world[1].xyz(), .world_up = world_up};
    view.vertical_fov_rad = camera.vertical_fov_rad;
    view.horizontal_fov_rad = camera.horizontal_fov_rad;
    view.orthographic = is_parallel;
    double distance = 1, moved = 0;
    if (is_parallel) {
        distance = camera.half_height / math::tan(0.5 * camera.vertical_fov_rad);
        view.horizontal_fov_rad.reset();
        if (camera.half_width) view.horizontal_fov_rad = 2 * math::atan2(*camera.half_width, distance);
        if (!(camera.z_near > 0)) moved = 0.001 * (camera.z_far - camera.z_near) - camera.z_near;
    }
    view.position = camera.to_world[3].xyz() + back * moved;
    view.focal_point = *view.position - back * distance;
    view.z_near = camera.z_near + moved, view.z_far = camera.z_far + moved;
    return view;
}

/// One look, one camera, one scale of colors.
void choose_for_both(const Scene& all, PictureRequest& a, PictureRequest& b, Context& context) {
    if (a.look == Look::plain || b.look == Look::plain) a.look = b.look = Look::plain;
    const std::optional<ViewRequest> view = common_view(a.view, b.view);
    if (view) a.view = b.view = *view;
    take_given(a, b), take_given(b, a);
    Context quiet({.threads = context.threads(), .max_memory = context.memory().limit(), .parent = &context});
    apply_look(all, a, context);
    apply_look(all, b, quiet);  // the same remarks
    if (a.coloring == b.coloring) a.coloring = b.coloring = completed(all, a.coloring);
    if (!view) return;
    const double aspect = double(a.settings.width) / double(a.settings.height);
    const Visibility visibility = (loses_by_near(a.settings.visibility) ? a : b).settings.visibility;
    a.view = b.view = view_through(valid::choose_camera(all, a.view, aspect, visibility, context), a.view.world_up);
}

Scene loaded_at_moment(PictureRequest& request, Context& context) {
    try {
        request.output.clear();
        request.settings.channels = 0;
        check_drawing(request);
        Scene loaded = load(request.input, request.load, context);
        const std::vector<ClipTime> clips = clips_of(loaded, request.motion);
        return at_moment(std::move(loaded), clips, context);
    } catch (const Error& error) {
        throw error.with_file(request.input);
    }
}

/// @param asked  see decide_moment()
Pixels drawn(Scene moment, const PictureRequest& asked, PictureRequest& request, Context& context) {
    Pixels pixels;
    PixelsTarget target(pixels);
    draw_moment(std::move(moment), asked, request, target, context);
    return pixels;
}

}  // namespace

std::pair<Pixels, Pixels> draw_alike(PictureRequest a, PictureRequest b, Context& context) {
    Scene scene_a = loaded_at_moment(a, context), scene_b = loaded_at_moment(b, context);
    share_up(scene_a, a, scene_b, b, context.report());
    share_light(scene_a, scene_b), share_light(scene_b, scene_a);
    choose_for_both(both(scene_a, scene_b, context), a, b, context);
    a.coloring = completed(scene_a, a.coloring), b.coloring = completed(scene_b, b.coloring);
    Pixels picture_a = drawn(std::move(scene_a), PictureRequest(a), a, context);
    const PictureRequest asked_b = b;  // materials, points and light by its own choices
    follow(b, a);
    b.look = Look::plain;  // all of it is chosen
    return {std::move(picture_a), drawn(std::move(scene_b), asked_b, b, context)};
}

}  // namespace rakelight
