// SPDX-License-Identifier: Apache-2.0
#include "render/look.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include <rakelight/base/report.h>
#include <rakelight/io/world.h>
#include <rakelight/scene/scene_queries.h>

#include "prepare/pose_scene.h"
#include "render/camera/camera_chooser.h"
#include "render/camera/up_axis.h"
#include "scene/faults.h"
#include "world/z_up.h"

namespace rakelight {
namespace {

constexpr int usual_samples = 4;
constexpr int soft_shadow_filter = 2;     ///< [texels]
constexpr double least_seen_share = 0.9;  ///< of the model, by a camera of the file that is taken unasked

/// A mesh that is drawn has such a material, or none.
bool draws_metallic_roughness(const Scene& scene) {
    const auto is_such = [&](std::uint32_t mesh) {
        const std::uint32_t material = scene.meshes[mesh].material;
        return material != no_index && scene.materials[material].model == MaterialModel::metallic_roughness;
    };
    return std::ranges::any_of(scene.nodes,
                               [&](const Node& node) { return std::ranges::any_of(node.meshes, is_such); });
}

void note(Context& context, const PictureRequest& request, const std::string& text, std::vector<std::string> settings) {
    context.report().add(Remark::note, request.input, "", text, std::move(settings));
}

/// The file's first camera with the file's lights, or neither. @return whether the lights are taken
bool take_camera(const Scene& scene, PictureRequest& request, Context& context) {
    if (scene.cameras.empty() || !request.view.side.empty() || !request.view.camera.empty() || request.view.is_placed())
        return true;
    const double aspect = double(request.settings.width) / double(request.settings.height);
    const Camera camera = camera_of_file(scene, 0, aspect);
    const double share = fault_of(camera, CameraUse::in_engine) ? 0 : seen_share(scene, camera, aspect);
    const std::string of_it = std::to_string(int(std::floor(100 * share))) + " % of the model";
    const std::string lights = scene.lights.empty() ? "" : " and lights";
    if (share >= least_seen_share) {
        note(context, request,
             "the file's camera" + (lights.empty() ? " is" : lights + " are") + " used: it shows " + of_it +
                 "; 'view' default fits the model",
             {"view"});
        return true;
    }
    request.view.side = "default";
    note(context, request,
         "the file's camera shows " + of_it + ": the fitted view" +
             (lights.empty() ? " is" : " and the default light are") + " used; 'view' file uses the file's camera" +
             lights,
         {"view"});
    return false;
}

/// Advice, if neither the request nor the format gives the up axis.
void advise_up(const Scene& scene, PictureRequest& request, bool is_z_up, Context& context) {
    if (names(request, {"camera-position", "camera-direction", "view", "camera-index"})) return;
    const std::string why = is_z_up ? why_y_is_up(scene) : why_z_is_up(scene), axis = is_z_up ? "Y" : "Z";
    if (!why.empty())
        context.report().add(
            Remark::warning, request.input, "",
            "the model looks as if " + axis + " were up: " + why + "; 'up' +" + axis + " turns it upright", {"up"});
}

/// STL files have Z up in any look. @param scene  as loaded
void take_up_axis(const Scene& scene, PictureRequest& request, Context& context) {
    if (names(request, {"up", "camera-view-up"}) || request.view.up || request.view.world_up) return;
    const std::string& path = scene.source.empty() ? request.input : scene.source;
    const bool has_z_up = is_z_up(path, request.load.joined);
    if (has_z_up) {
        request.view.world_up = dvec3{0, 0, 1};
        note(context, request, "STL files do not say which axis is up: Z is used; see 'up'", {"up"});
    } else if (const auto lying = lying_file(path, request.load.joined)) {
        const std::string why = beside_y_up + std::string(" ('up' +Z turns all of them)");
        return warn_of_lying(*lying, "", why, context.report(), {"up"});
    }
    if (request.look != Look::plain && has_no_up_axis(path)) advise_up(scene, request, has_z_up, context);
}

/// Metallic-roughness materials are lit by the studio, unless a light is given.
void take_light(const Scene& scene, bool takes_file, PictureRequest& request) {
    if (!takes_file && !names(request, "light")) request.default_lights = !scene.lights.empty();
    if (request.preset != Preset::none) return;
    if (scene.environment || request.fog || scene.fog.kind != FogKind::none) return;
    if (names(request, {"light", "lighting", "shading", "specular", "hdri-file", "hdri-ambient", "hdri-skybox"}))
        return;
    if (!draws_metallic_roughness(scene)) return;
    if (takes_file && !scene.lights.empty()) {  // they stay, and the studio gives what they leave dark
        request.hdri_ambient = true;
        return;
    }
    request.studio_lights = true, request.default_lights = false;
    if (names(request, "shadows")) return;
    request.settings.shadows = true;
    if (!names(request, "shadow-filter")) request.settings.shadow_filter = soft_shadow_filter;
}

void take_samples(PictureRequest& request) {
    if (!names(request, {"samples", "visibility"}) && request.settings.visibility == Visibility::z_reversed)
        request.settings.samples = usual_samples;
}

/// A world has its own cameras, and its own light if it has any, as bright as it says. Unless the look is given, samples
/// are all that is chosen.
void take_look_of_world(const Scene& world, PictureRequest& request) {
    const bool is_traced = request.engine == "trace";
    if (!is_traced) take_samples(request);
    if (!names(request, "look")) {
        request.look = Look::plain;
        return;
    }
    const bool is_lit = !world.lights.empty() || world.environment || world.fog.kind != FogKind::none;
    if (is_lit)
        request.given_keys.emplace_back("exposure");
    else if (!is_traced && request.settings.method != RayMethod::radiosity)
        take_light(world, true, request);
}

void take_look_of_posed(const Scene& scene, PictureRequest& request, Context& context) {
    if (is_world_file(scene.source)) return take_look_of_world(scene, request);
    if (request.engine == "trace") return;
    const bool takes_file = take_camera(scene, request, context);
    if (request.settings.method != RayMethod::radiosity) take_light(scene, takes_file, request);
    take_samples(request);
}

}  // namespace

bool names(const PictureRequest& request, std::string_view key) {
    return std::ranges::find(request.given_keys, key) != request.given_keys.end();
}

bool names(const PictureRequest& request, std::initializer_list<std::string_view> keys) {
    return std::ranges::any_of(keys, [&](std::string_view key) { return names(request, key); });
}

void apply_look(const Scene& scene, PictureRequest& request, Context& context) {
    take_up_axis(scene, request, context);
    if (request.look == Look::plain) return;
    const std::optional<Scene> posed = posed_outline(scene, context);
    take_look_of_posed(posed ? *posed : scene, request, context);
}

}  // namespace rakelight
