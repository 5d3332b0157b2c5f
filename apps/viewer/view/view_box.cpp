// SPDX-License-Identifier: Apache-2.0
#include "view_box.h"

#include <algorithm>
#include <mutex>
#include <optional>

#include <rakelight/math/linear.h>
#include <rakelight/render/picture.h>

namespace rakelight::viewer {
namespace {

/// A node with one vertex, at `place` to the bit.
void add_vertex(Scene& scene, dvec3 place) {
    Mesh mesh;
    mesh.topology = Topology::points;
    mesh.positions = std::vector<vec3>{{0, 0, 0}};
    mesh.indices = std::vector<std::uint32_t>{0};
    Node node;
    node.local.translation = place;
    node.meshes = {std::uint32_t(scene.meshes.size())};
    scene.meshes.push_back(std::move(mesh));
    scene.nodes.push_back(std::move(node));
}

/// The nodes that carry cameras and lights, and those that carry them, without their meshes. Parents come first, as in every scene.
/// @return the number that each node has now; no_index: it is left out
std::vector<std::uint32_t> add_carriers(Scene& to, const Scene& from) {
    std::vector<bool> carries(from.nodes.size(), false);
    const auto mark = [&](std::uint32_t node) {
        for (std::uint32_t n = node; n < from.nodes.size() && !carries[n]; n = from.nodes[n].parent) carries[n] = true;
    };
    for (const Camera& camera : from.cameras) mark(camera.node);
    for (const Light& light : from.lights) mark(light.node);
    std::vector<std::uint32_t> number(from.nodes.size(), no_index);
    for (std::size_t i = 0; i < from.nodes.size(); ++i) {
        if (!carries[i]) continue;
        const Node& node = from.nodes[i];
        number[i] = std::uint32_t(to.nodes.size());
        to.nodes.push_back({.name = node.name, .local = from.pose ? from.pose->local[i] : node.local});
        if (node.parent != no_index) to.nodes.back().parent = number[node.parent];
    }
    for (Camera& camera : to.cameras)
        if (camera.node < number.size()) camera.node = number[camera.node];
    for (Light& light : to.lights)
        if (light.node < number.size()) light.node = number[light.node];
    return number;
}

/// The animation of those nodes, the cameras and the lights.
std::vector<Animation> motion_of(const Scene& scene, std::span<const std::uint32_t> number) {
    std::vector<Animation> motion;
    for (const Animation& animation : scene.animations) {
        Animation& kept = motion.emplace_back();
        for (const AnimationChannel& channel : animation.channels) {
            const bool is_placement = channel.is_of_node() && channel.path != AnimationPath::morph_weights;
            const bool is_kept = is_placement
                                     ? channel.element < number.size() && number[channel.element] != no_index
                                     : channel.path == AnimationPath::camera || channel.path == AnimationPath::light;
            if (!is_kept) continue;
            kept.channels.push_back(channel);
            if (is_placement) kept.channels.back().element = number[channel.element];
        }
    }
    return motion;
}

/// The camera chooser of a scene at its pose. It drops normals, tangents and clips: they would be turned or checked for
/// nothing.
CameraChooser chooser_of(Scene scene) {
    scene.animations.clear();
    for (Mesh& mesh : scene.meshes) mesh.normals = {}, mesh.tangents = {};
    Context quiet({.threads = 1});
    return CameraChooser(std::move(scene), quiet);
}

std::vector<Light> placed(const Scene& scene) {
    std::vector<Light> lights = scene.lights;
    const std::vector<dmat4> world = node_matrices(scene);
    for (Light& light : lights) {
        if (light.node >= world.size()) continue;
        const dmat4& m = world[light.node];
        light.position = m[3].xyz();
        light.direction = normalize_or(-m[2].xyz(), dvec3{0, 0, -1});
        light.node = no_index;
    }
    return lights;
}

std::string title_of(const Camera& camera, std::size_t number) {
    return camera.name.empty() ? "camera " + std::to_string(number) : one_line(camera.name, 60);
}

}  // namespace

std::vector<dmat4> node_matrices(const Scene& scene) {
    std::vector<dmat4> world(scene.nodes.size());
    for (std::size_t i = 0; i < world.size(); ++i) {
        const Node& node = scene.nodes[i];
        const Transform& t = scene.pose ? scene.pose->local[i] : node.local;
        const dmat4 local = t.matrix ? *t.matrix : compose(t.translation, t.rotation, t.scale);
        world[i] = node.parent == no_index ? local : world[node.parent] * local;
    }
    return world;
}

dvec3 position_in_world(const dmat4& world, const Mesh& mesh, std::size_t vertex) {
    return transform_point(world, mesh.origin + cast<double>(mesh.positions[vertex]));
}

struct ViewBox::Known {
    std::mutex mutex;
    std::optional<Scene> still;  ///< the scene without its clips: copying them takes as long as posing
    std::vector<ClipTime> clips;
    std::optional<CameraChooser> chooser;  ///< of the scene at these clips
};

ViewBox::ViewBox(const Scene& scene)
    : chooser_(std::make_shared<const CameraChooser>(chooser_of(scene))),
      bounds_(chooser_->bounds()),
      known_(std::make_shared<Known>()) {
    if (bounds_.empty()) throw Error(ErrorCode::bad_file, "nothing to draw").with_file(scene.source);
    stand_in_.source = scene.source;
    stand_in_.cameras = scene.cameras;
    stand_in_.lights = scene.lights;
    motion_ = motion_of(scene, add_carriers(stand_in_, scene));
    add_vertex(stand_in_, bounds_.low);
    add_vertex(stand_in_, bounds_.high);
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) cameras_.push_back(title_of(scene.cameras[i], i));
}

Scene ViewBox::stand_in_at(std::span<const ClipTime> clips) const {
    if (clips.empty()) return stand_in_;
    Scene scene = stand_in_;
    scene.animations = motion_;
    scene = scene_at(std::move(scene), clips);
    scene.animations.clear();
    return scene;
}

std::vector<Light> ViewBox::lights(std::span<const ClipTime> clips) const { return placed(stand_in_at(clips)); }

Camera ViewBox::camera(const Scene& scene, const ViewRequest& view, double aspect, std::span<const ClipTime> clips,
                       Visibility visibility) const {
    Context quiet({.threads = 1});
    if (clips.empty()) return chooser_->choose(view, aspect, visibility, quiet);
    const std::lock_guard lock(known_->mutex);  // painters ask, too
    Known& known = *known_;
    if (!known.chooser || !std::ranges::equal(known.clips, clips)) {
        known.chooser.reset();
        if (!known.still) known.still = scene, known.still->animations.clear();
        known.chooser.emplace(chooser_of(scene_at(*known.still, scene.animations, clips, quiet.memory())));
        known.clips.assign(clips.begin(), clips.end());
    }
    return known.chooser->choose(view, aspect, visibility, quiet);
}

Camera ViewBox::quick_camera(const Scene& scene, const ViewRequest& view, double aspect,
                             std::span<const ClipTime> clips, Visibility visibility) const {
    const bool is_placed = view.position && view.focal_point;
    const bool is_of_file =
        !cameras_.empty() && (!view.camera.empty() || view.side == "file" || (view.side.empty() && !view.is_placed()));
    if (!is_placed && !is_of_file) return camera(scene, view, aspect, clips, visibility);
    Context quiet({.threads = 1});
    if (is_placed || clips.empty()) return chooser_->choose(view, aspect, visibility, quiet);
    return choose_camera(stand_in_at(clips), view, aspect, visibility, quiet);
}

}  // namespace rakelight::viewer
