// SPDX-License-Identifier: Apache-2.0
#include "view_box.h"

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

std::string title_of(const Camera& camera, std::size_t number) {
    return camera.name.empty() ? "camera " + std::to_string(number) : one_line(camera.name, 60);
}

}  // namespace

ViewBox::ViewBox(const Scene& scene) : bounds_(rakelight::bounds(scene)) {
    if (bounds_.empty()) throw Error(ErrorCode::bad_file, "nothing to draw").with_file(scene.source);
    stand_in_.source = scene.source;
    stand_in_.cameras = scene.cameras;
    if (!scene.cameras.empty()) stand_in_.nodes = scene.nodes;
    for (Node& node : stand_in_.nodes) {
        node.meshes.clear();
        node.morph_weights.clear();
        node.skin = no_index;
    }
    add_vertex(stand_in_, bounds_.low);
    add_vertex(stand_in_, bounds_.high);
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) cameras_.push_back(title_of(scene.cameras[i], i));
}

Camera ViewBox::camera(const ViewRequest& view, double aspect) const {
    Context quiet({.threads = 1});
    return choose_camera(stand_in_, view, aspect, quiet);
}

}  // namespace rakelight::viewer
