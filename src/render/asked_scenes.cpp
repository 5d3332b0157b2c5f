// SPDX-License-Identifier: Apache-2.0
#include "render/asked_scenes.h"

#include <algorithm>
#include <utility>

#include <rakelight/render/shot.h>
#include <rakelight/scene/validate.h>

#include "render/look.h"
#include "render/point_look.h"
#include "scene/motion/motion.h"
#include "world/coloring.h"
#include "world/scene_of_request.h"

namespace rakelight {

// What with_surfaces() reads.
PictureRequest surfaces_of(const PictureRequest& r) {
    PictureRequest s;
    s.input = r.input, s.look = r.look, s.preset = r.preset;
    if (names(r, "point-size")) s.given_keys = {"point-size"};
    s.materials = r.materials, s.coloring = r.coloring, s.coloring.has_bar = false;
    s.hdri_file = r.hdri_file, s.hdri_ambient = r.hdri_ambient, s.hdri_skybox = r.hdri_skybox;
    s.hdri_intensity = r.hdri_intensity, s.hdri_rotation_rad = r.hdri_rotation_rad;
    s.studio_lights = r.studio_lights, s.view.world_up = r.view.world_up;
    s.settings.lighting = r.settings.lighting, s.settings.lighting_text = r.settings.lighting_text;
    s.settings.bump = r.settings.bump;
    s.settings.points = r.settings.points, s.settings.surfaces = r.settings.surfaces,
    s.settings.edges = r.settings.edges;
    return s;
}

namespace {

/// Then materials are changed as they are at the moment.
bool depends_on_moment(const Scene& scene, const PictureRequest& request, std::span<const ClipTime> clips) {
    if (request.materials == MaterialOverrides{} && request.preset == Preset::none && !request.coloring.is_on)
        return false;
    const auto moves_material = [](const AnimationChannel& c) { return c.path == AnimationPath::material; };
    return std::ranges::any_of(clips, [&](const ClipTime& clip) {
        return std::ranges::any_of(scene.animations[clip.animation].channels, moves_material);
    });
}

Scene with_surfaces(Scene scene, const PictureRequest& request, Context& context) {
    return with_splats(with_requested_surfaces(std::move(scene), request, context), request, context);
}

Scene changed(Scene scene, const PictureRequest& request, Context& context) {
    scene = with_surfaces(std::move(scene), request, context);
    scene.fog = request.fog.value_or(scene.fog);
    return scene;
}

}  // namespace

Scene at_moment(Scene loaded, std::span<const ClipTime> clips, Context& context) {
    return scene_at(std::move(loaded), clips, context.memory());
}

Scene asked_single(Scene moment, PictureRequest& request, Context& context) {
    request.coloring = completed(moment, request.coloring);
    return changed(std::move(moment), request, context);
}

Scene as_requested(Scene scene, const PictureRequest& request, Context& context) {
    validate(scene);
    return changed(std::move(scene), request, context);
}

Scene AskedScenes::at(const std::shared_ptr<const Scene>& loaded, const PictureRequest& request,
                      std::span<const ClipTime> clips, Context& context) {
    check_clips(*loaded, clips);
    const bool is_of_moment = depends_on_moment(*loaded, request, clips);
    std::vector<ClipTime> surface_clips;
    if (is_of_moment) surface_clips.assign(clips.begin(), clips.end());
    PictureRequest surfaces = surfaces_of(request);
    if (loaded != loaded_ || surfaces_ != surfaces || clips_ != surface_clips) {
        loaded_.reset();
        asked_ = with_surfaces(at_moment(*loaded, surface_clips, context), request, context);
        asked_.animations.clear();
        loaded_ = loaded, surfaces_ = std::move(surfaces), clips_ = std::move(surface_clips);
    }
    Scene scene = is_of_moment ? asked_ : scene_at(asked_, loaded->animations, clips, context.memory());
    // What may move is prepared alike at rest.
    if (!scene.pose && !loaded->animations.empty()) scene.pose = rest_pose(scene);
    scene.fog = request.fog.value_or(scene.fog);
    return scene;
}

}  // namespace rakelight
