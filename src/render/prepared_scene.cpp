// SPDX-License-Identifier: Apache-2.0
#include "render/prepared_scene.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include <rakelight/scene/scene_queries.h>

#include "engines/posed_arrays.h"
#include "prepare/prepare_scene.h"
#include "render/camera/camera_chooser.h"
#include "render/height_maps.h"
#include "scene/placement.h"
#include "world/scene_of_request.h"

namespace rakelight {
namespace {

/// Some mesh that is drawn emits light.
bool has_shining_surface(const Scene& scene) {
    const auto shines = [&](std::uint32_t mesh) {
        const std::uint32_t material = scene.meshes[mesh].material;
        return material != no_index && scene.materials[material].model != MaterialModel::unlit &&
               scene.materials[material].emission != vec3{};
    };
    return std::ranges::any_of(scene.nodes, [&](const Node& n) { return std::ranges::any_of(n.meshes, shines); });
}

}  // namespace

bool are_prepared_alike(const Scene& a, const Scene& b) {
    return a.nodes == b.nodes && a.meshes == b.meshes && a.materials == b.materials && a.textures == b.textures &&
           a.skins == b.skins && is_posable(a) == is_posable(b) &&
           a.missing_normals_are_flat == b.missing_normals_are_flat && a.source == b.source;
}

namespace {

std::uint64_t new_number() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

}  // namespace

bool have_same_surroundings(const Scene& a, const Scene& b) {
    return a.lights == b.lights && a.cameras == b.cameras && a.fog == b.fog && a.environment == b.environment;
}

const Scene& PosedOnce::of(const PreparedScene& prepared, Context& context) const {
    const std::scoped_lock lock(shared_->mutex);
    if (!shared_->meshes) shared_->meshes = with_posed_arrays(prepared.scene, *prepared.poses, context).meshes;
    if (!scene_) {
        scene_ = prepared.scene;
        scene_->meshes = *shared_->meshes;
    }
    return *scene_;
}

Scene PosedOnce::take(PreparedScene&& prepared, Context& context) {
    if (!prepared.poses) return std::move(prepared.scene);
    const std::scoped_lock lock(shared_->mutex);
    if (!shared_->meshes) return with_posed_arrays(std::move(prepared.scene), *prepared.poses, context);
    prepared.scene.meshes = *shared_->meshes;
    return std::move(prepared.scene);
}

bool are_drawn_alike(const PreparedScene& a, const PreparedScene& b) {
    return &a == &b || (a.number != 0 && a.number == b.number);
}

void take_surroundings(PreparedScene& prepared, const Scene& scene) {
    prepared.posed_.forget();
    if (!(prepared.scene.fog == scene.fog) || prepared.scene.environment != scene.environment)
        prepared.number = new_number();
    prepared.scene.lights = scene.lights;
    prepared.scene.cameras = scene.cameras;
    prepared.scene.fog = scene.fog;
    prepared.scene.environment = scene.environment;
}

namespace {

void take(UnposedScene unposed, PreparedScene& to) {
    to.scene = std::move(unposed.scene);
    if (!unposed.poses.empty()) to.poses = std::make_shared<const geometry::MeshPoses>(std::move(unposed.poses));
}

}  // namespace

PrepareOptions options_for(PrepareOptions options, const RenderSettings& settings, const Scene& scene) {
    options.all_tangents |= (settings.channels & channel_tangent) != 0;
    options.clockwise_fronts |= settings.front_face == FrontFace::clockwise;
    options.bump = settings.bump;
    options.displacement.is_on |= settings.bump == Bump::displacement;
    const bool displaces = options.displacement.is_on || std::ranges::any_of(scene.materials, [](const Material& m) {
                               return m.bump == Bump::displacement;
                           });
    if (displaces) options.displacement.relief = settings.relief;
    return options;
}

std::shared_ptr<PreparedScene> make_prepared(Scene scene, const PrepareOptions& options, const RenderSettings& settings,
                                             Context& context) {
    auto out = std::make_shared<PreparedScene>();
    out->number = new_number();
    out->options = options_for(options, settings, scene);
    scene = with_height_maps(std::move(scene), settings, context);
    if (!has_bind_pose(scene, out->options)) {
        out->scene = valid::prepare_scene(std::move(scene), out->options, context);
        return out;
    }
    out->pose = scene.pose;
    out->bound = std::make_shared<const BoundScene>(bind_scene(std::move(scene), out->options, context));
    take(finish_unposed(*out->bound, out->pose, out->options, context), *out);
    return out;
}

std::shared_ptr<PreparedScene> make_posed(const PreparedScene& prepared, const Rare<ScenePose>& pose,
                                          Context& context) {
    auto out = std::make_shared<PreparedScene>();
    out->number = new_number();
    out->options = prepared.options, out->bound = prepared.bound, out->pose = pose;
    take(finish_unposed(*prepared.bound, pose, prepared.options, context), *out);
    return out;
}

Camera camera_in_world(const Scene& scene, Camera camera, double aspect) {
    camera.to_world = camera_to_world(scene, camera, world_matrices(scene));
    camera.node = no_index;
    return adapt_to_aspect(std::move(camera), aspect);
}

namespace {

bool is_lit_by(const std::vector<Light>& own, const Scene& scene, RayMethod method) {
    return !own.empty() || is_lit_by_environment(scene) ||
           ((method == RayMethod::path || method == RayMethod::radiosity) && has_shining_surface(scene));
}

}  // namespace

std::vector<Light> lights_of(const Scene& scene, const std::vector<Light>& own, const Shot& shot) {
    if (shot.settings.method == RayMethod::radiosity) return {};  // they are in the colors
    if (shot.lights) return *shot.lights;
    if (is_lit_by(own, scene, shot.settings.method)) return own;
    return default_lights(camera_in_world(scene, shot.camera, aspect_of(shot.settings)).to_world);
}

std::vector<Light> lights_of(const Scene& scene, const Camera& camera, RayMethod method) {
    return is_lit_by(scene.lights, scene, method) ? scene.lights : default_lights(camera.to_world);
}

double aspect_of(const RenderSettings& settings) { return double(settings.width) / double(settings.height); }

std::vector<Light> lights_of(const Scene& scene, const Shot& shot) { return lights_of(scene, scene.lights, shot); }

Scene drawn_scene(const PreparedScene& prepared, const Shot& shot, Context& context) {
    Scene scene = prepared.posed(context);
    scene.lights = lights_of(prepared.scene, shot);
    return scene;
}

}  // namespace rakelight
