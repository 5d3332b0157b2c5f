// SPDX-License-Identifier: Apache-2.0
#include "view_box.h"

#include <mutex>

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

/// The nodes that carry cameras, and those that carry them, without their meshes. Parents come first, as in every scene.
void add_carriers(Scene& to, const Scene& from) {
    std::vector<bool> carries(from.nodes.size(), false);
    for (const Camera& camera : from.cameras)
        for (std::uint32_t n = camera.node; n < from.nodes.size() && !carries[n]; n = from.nodes[n].parent)
            carries[n] = true;
    std::vector<std::uint32_t> number(from.nodes.size(), no_index);
    for (std::size_t i = 0; i < from.nodes.size(); ++i) {
        if (!carries[i]) continue;
        const Node& node = from.nodes[i];
        number[i] = std::uint32_t(to.nodes.size());
        to.nodes.push_back({.name = node.name, .local = node.local});
        if (node.parent != no_index) to.nodes.back().parent = number[node.parent];
    }
    for (Camera& camera : to.cameras)
        if (camera.node < number.size()) camera.node = number[camera.node];
}

std::string title_of(const Camera& camera, std::size_t number) {
    return camera.name.empty() ? "camera " + std::to_string(number) : one_line(camera.name, 60);
}

}  // namespace

struct ViewBox::Known {
    std::mutex mutex;
    ViewRequest view;
    double aspect = 0;  ///< 0: nothing is known
    Camera camera;
};

ViewBox::ViewBox(const Scene& scene) : bounds_(rakelight::bounds(scene)), known_(std::make_shared<Known>()) {
    if (bounds_.empty()) throw Error(ErrorCode::bad_file, "nothing to draw").with_file(scene.source);
    stand_in_.source = scene.source;
    stand_in_.cameras = scene.cameras;
    add_carriers(stand_in_, scene);
    add_vertex(stand_in_, bounds_.low);
    add_vertex(stand_in_, bounds_.high);
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) cameras_.push_back(title_of(scene.cameras[i], i));
}

Camera ViewBox::camera(const Scene& scene, const ViewRequest& view, double aspect) const {
    Context quiet({.threads = 1});
    if (view.position && view.focal_point) return choose_camera(stand_in_, view, aspect, quiet);
    const std::lock_guard lock(known_->mutex);  // painters ask, too
    if (known_->aspect != aspect || known_->view != view) {
        known_->aspect = 0;
        known_->camera = choose_camera(scene, view, aspect, quiet);
        known_->view = view, known_->aspect = aspect;
    }
    return known_->camera;
}

}  // namespace rakelight::viewer
