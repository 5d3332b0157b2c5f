// SPDX-License-Identifier: Apache-2.0
#include "commands.h"

#include <algorithm>
#include <cmath>

#include <rakelight/math/linear.h>
#include <rakelight/version.h>

namespace rakelight::viewer {
namespace {

/// The value behind `value` in a list; the first behind the last, and for one that is not in it.
template <class T, std::size_t n>
T next(const T (&values)[n], T value) {
    const auto at = std::ranges::find(values, value);
    return at == std::end(values) || at + 1 == std::end(values) ? values[0] : *(at + 1);
}

void show_side(Look& look, const char* side) {
    const bool is_parallel = look.eye ? look.eye->is_orthographic : look.request.view.orthographic;
    look.eye.reset();
    const ViewRequest& was = look.request.view;
    look.request.view = {
        .side = side, .world_up = was.world_up, .z_near = was.z_near, .z_far = was.z_far, .orthographic = is_parallel};
    if (look.world_up != dvec3{0, 1, 0}) look.request.view.world_up = look.world_up;
}

/// From one that the user has moved away from, back to it.
void next_camera(Look& look, const Model& model) {
    const std::size_t count = model.box.cameras().size();
    if (count == 0) return;
    const std::optional<std::size_t> now = current_camera(look, model);
    look.eye.reset();
    const std::size_t number = now ? (*now + 1) % count : current_camera(look, model).value_or(0);
    look.request.view = {.camera = std::to_string(number), .world_up = look.request.view.world_up};
}

void next_up_axis(Look& look) {
    const dvec3 up = look.world_up;
    look.world_up = up == dvec3{0, 1, 0} ? dvec3{0, 0, 1} : up == dvec3{0, 0, 1} ? dvec3{1, 0, 0} : dvec3{0, 1, 0};
    look.request.view.world_up = look.world_up;
    show_side(look, "default");
}

/// The whole model, seen from where the eye is now.
void show_all(Look& look, const Model& model, int width, int height) {
    Eye& eye = moving_eye(look, model, width, height);
    ViewRequest all{.up = eye.up, .world_up = look.world_up, .direction = forward_of(eye)};
    all.vertical_fov_rad = radians(eye.fov_deg);
    if (eye.horizontal_fov_deg) all.horizontal_fov_rad = radians(*eye.horizontal_fov_deg);
    all.orthographic = eye.is_orthographic;
    const double fov_deg = eye.fov_deg;
    const Camera camera = model.box.camera(model.scene, all, double(width) / double(height), clips_of(look, model));
    const Eye fitted = eye_of(camera, model.box.bounds());
    eye.position = fitted.position, eye.focal = fitted.focal, eye.fov_deg = fov_deg;
}

/// Over the poles too, where the turntable would stop.
void raise(Look& look, const Model& model, int width, int height, double angle_rad) {
    Eye& eye = moving_eye(look, model, width, height);
    const double distance = distance_of(eye);
    const dvec3 right = right_of(eye), to_eye = rotated(-forward_of(eye), right, -angle_rad);
    eye.up = rotated(eye.up, right, -angle_rad);
    eye.position = eye.focal + to_eye * distance;
}

bool apply_to_view(Command command, Look& look, const Model& model, int width, int height) {
    switch (command) {
        case Command::fit:
            return show_all(look, model, width, height), true;
        case Command::reset_view:
            look.eye.reset();
            look.request.view = model.request.view;
            return true;
        case Command::front:
            return show_side(look, "front"), true;
        case Command::back:
            return show_side(look, "back"), true;
        case Command::right:
            return show_side(look, "right"), true;
        case Command::left:
            return show_side(look, "left"), true;
        case Command::top:
            return show_side(look, "top"), true;
        case Command::bottom:
            return show_side(look, "bottom"), true;
        case Command::isometric:
            return show_side(look, "isometric"), true;
        case Command::orthographic: {
            Eye& eye = moving_eye(look, model, width, height);
            eye.is_orthographic = !eye.is_orthographic;
            return true;
        }
        case Command::roll_left:
            return roll(moving_eye(look, model, width, height), radians(90)), true;
        case Command::roll_right:
            return roll(moving_eye(look, model, width, height), radians(-90)), true;
        case Command::raise:
            return raise(look, model, width, height, radians(90)), true;
        case Command::lower:
            return raise(look, model, width, height, radians(-90)), true;
        case Command::next_camera:
            return next_camera(look, model), true;
        case Command::up_axis:
            return next_up_axis(look), true;
        default:
            return false;
    }
}

void set_shading(PictureRequest& request) {
    constexpr Shading all[] = {Shading::phong, Shading::gouraud, Shading::flat, Shading::unlit, Shading::automatic};
    request.settings.shading = next(all, request.settings.shading);
    request.settings.material_shading = false;
    request.settings.shading_rules.clear();
}

void set_bump(PictureRequest& request) {
    constexpr Bump all[] = {Bump::automatic,        Bump::none,  Bump::height,    Bump::normal,      Bump::parallax,
                            Bump::parallax_limited, Bump::steep, Bump::occlusion, Bump::displacement};
    request.settings.bump = next(all, request.settings.bump);
}

void set_lighting(PictureRequest& request) {
    constexpr Lighting all[] = {Lighting::automatic,  Lighting::lambert,         Lighting::phong, Lighting::blinn_phong,
                                Lighting::oren_nayar, Lighting::oren_nayar_full, Lighting::ward,  Lighting::pbr};
    RenderSettings& s = request.settings;
    s.lighting = s.lighting_text.empty() ? next(all, s.lighting) : Lighting::automatic;
    s.lighting_name.clear(), s.lighting_text.clear(), s.uniforms.clear();
}

void set_wireframe(RenderSettings& s) {
    s.surfaces = !s.surfaces;
    s.edges = !s.surfaces;
}

void step_channel(Look& look, int by) {
    constexpr int count = 19;  // colors, and 18 bits
    static_assert(channels_all == (1u << (count - 1)) - 1);
    int now = 0;
    for (int i = 1; i < count; ++i)
        if (look.channel == 1u << (i - 1)) now = i;
    now = (now + by + count) % count;
    look.channel = now == 0 ? 0 : 1u << (now - 1);
}

/// Engines one after the other; of one that follows rays its plain method, then paths.
void next_engine(Look& look) {
    const PictureRequest& r = look.request;
    if (r.engine == "trace" && r.settings.method != RayMethod::path) return choose_method(RayMethod::path, look);
    const std::vector<std::string> all = build_info().engines;
    const auto at = std::ranges::find(all, r.engine);
    choose_engine(at == all.end() || at + 1 == all.end() ? all.front() : at[1], look);
}

int usual_samples(bool is_path) { return is_path ? 256 : PictureRequest().settings.samples; }

/// The method is left for one that every engine has.
void leave_rays(Look& look) {
    const RayMethod method = look.request.settings.method == RayMethod::path
                                 ? look.ray_method.value_or(RayMethod::automatic)
                                 : look.request.settings.method;
    const bool needs_rays = method == RayMethod::whitted || method == RayMethod::cast;
    choose_method(needs_rays ? RayMethod::automatic : method, look);
    look.ray_method.reset();
    if (needs_rays) look.ray_method = method;
    RenderSettings& s = look.request.settings;
    if (look.shadows_by_nature) s.shadows = look.shadows_by_nature = false;
}

void enter_rays(Look& look) {
    RenderSettings& s = look.request.settings;
    if (look.ray_method && s.method == RayMethod::automatic) choose_method(*look.ray_method, look);
    look.ray_method.reset();
    if (!s.shadows) s.shadows = look.shadows_by_nature = true;
}

bool apply_to_picture(Command command, Look& look, const Model& model) {
    PictureRequest& r = look.request;
    RenderSettings& s = r.settings;
    constexpr int samples[] = {1, 4, 8}, path_samples[] = {64, 256, 1024, 4096};
    constexpr ToneMapping tones[] = {ToneMapping::none, ToneMapping::reinhard, ToneMapping::neutral, ToneMapping::aces,
                                     ToneMapping::agx};
    const auto& own = model.scene.environment;
    switch (command) {
        case Command::shading:
            return set_shading(r), true;
        case Command::lighting:
            return set_lighting(r), true;
        case Command::bump:
            return set_bump(r), true;
        case Command::channel:
            return step_channel(look, 1), true;
        case Command::previous_channel:
            return step_channel(look, -1), true;
        case Command::samples:
            return s.samples = s.method == RayMethod::path ? next(path_samples, s.samples) : next(samples, s.samples),
                   true;
        case Command::tone:
            return r.tone.mapping = next(tones, r.tone.mapping), true;
        case Command::shadows:
            look.shadows_by_nature = false;
            return s.shadows = !s.shadows, true;
        case Command::edges:
            return s.edges = !s.edges, true;
        case Command::wireframe:
            return set_wireframe(s), true;
        case Command::points:
            return s.points = s.points == PointShape::none ? PointShape::disc : PointShape::none, true;
        case Command::environment_light:
            return r.hdri_ambient = !r.hdri_ambient.value_or(own && own->is_light), true;
        case Command::environment_background:
            return r.hdri_skybox = !r.hdri_skybox.value_or(own && own->is_background), true;
        case Command::brighter:
            return r.light_intensity = std::min(r.light_intensity * 1.25, 1e6), true;
        case Command::darker:
            return r.light_intensity = r.light_intensity * 0.8, true;
        case Command::engine:
            return next_engine(look), true;
        default:
            return false;
    }
}

}  // namespace

void choose_method(RayMethod method, Look& look) {
    RenderSettings& s = look.request.settings;
    const bool was_path = s.method == RayMethod::path, is_path = method == RayMethod::path;
    if (was_path != is_path) {
        const int left = s.samples;
        s.samples = look.other_samples.value_or(usual_samples(is_path));
        look.other_samples.reset();
        if (left != usual_samples(was_path)) look.other_samples = left;
        look.ray_method.reset();
        if (is_path && s.method != RayMethod::automatic) look.ray_method = s.method;
    }
    s.method = method;
}

void choose_engine(const std::string& name, Look& look) {
    const bool had_rays = look.request.engine == "trace", has_rays = name == "trace";
    if (had_rays && !has_rays) leave_rays(look);
    look.request.engine = name;
    if (has_rays && !had_rays) enter_rays(look);
}

bool apply(Command command, Look& look, const Model& model, int width, int height) {
    return apply_to_view(command, look, model, width, height) || apply_to_picture(command, look, model);
}

std::string toggle_follows_camera(Look& look, const Model& model, int width, int height, std::size_t light) {
    std::vector<LightItem>& lights = changing_lights(look, model, width, height);
    if (light >= lights.size()) return "there is no light that could follow the camera";
    LightItem& item = lights[light];
    item.follows_camera = !item.follows_camera;
    const std::string name = item.light.name.empty() ? "light " + std::to_string(light) : one_line(item.light.name, 40);
    return name + (item.follows_camera ? " follows the camera" : " stays where it is");
}

}  // namespace rakelight::viewer
