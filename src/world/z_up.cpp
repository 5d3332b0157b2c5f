// SPDX-License-Identifier: Apache-2.0
#include "world/z_up.h"

#include <algorithm>

#include <rakelight/base/report.h>
#include <rakelight_internal/base/file_ending.h>

#include "math/linear.h"
#include "scene/placement.h"

namespace rakelight {

UpAxis up_axis(const std::string& path) {
    constexpr const char* open[] = {"ply", "off", "xyz", "pts"};
    const std::string ending = file_ending(path);
    if (ending == "stl") return UpAxis::z;
    return std::ranges::find(open, ending) != std::end(open) ? UpAxis::open : UpAxis::y;
}

bool is_z_up(const std::string& path, std::span<const std::string> joined) {
    const auto is_such = [](const std::string& file) { return up_axis(file) == UpAxis::z; };
    return is_such(path) && std::ranges::all_of(joined, is_such);
}

std::optional<std::string> lying_file(const std::string& path, std::span<const std::string> joined) {
    if (is_z_up(path, joined)) return {};
    if (up_axis(path) == UpAxis::z) return path;
    const auto lying = std::ranges::find(joined, UpAxis::z, up_axis);
    return lying == joined.end() ? std::nullopt : std::optional(*lying);
}

void warn_of_lying(const std::string& file, const std::string& place, const std::string& why, Report& report,
                   std::vector<std::string> settings) {
    report.add(Remark::warning, file, place,
               "the STL file has Z up and lies on its side " + why +
                   "; rotation_deg = [-90, 0, 0] in a world file turns it upright",
               std::move(settings));
}

Scene with_y_up(Scene scene) {
    constexpr dmat4 turn{{{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}}};
    const std::vector<dmat4> world = world_matrices(scene);
    for (std::size_t n = 0; n < scene.nodes.size(); ++n)
        if (scene.nodes[n].parent == no_index) scene.nodes[n].local.matrix = turn * world[n];
    for (Light& light : scene.lights) {
        if (light.node != no_index) continue;
        light.position = transform_point(turn, light.position);
        light.direction = transform_direction(turn, light.direction);
    }
    for (Camera& camera : scene.cameras)
        if (camera.node == no_index) camera.to_world = turn * camera.to_world;
    if (scene.environment) scene.environment->up = transform_direction(turn, scene.environment->up);
    return scene;
}

Scene with_y_up(Scene scene, const std::string& file, Report& report) {
    report.add(Remark::changed, file, {}, "the model was turned to Y up, because it has Z up");
    return with_y_up(std::move(scene));
}

void warn_of_z_up(const std::string& file, Report& report) {
    report.add(Remark::warning, file, {},
               "Z is up, as in the model; pictures of PLY files have Y up, and 'up' +Z shows it upright", {"up"});
}

std::optional<UpAxis> share_up_axis(Scene& a, Scene& b, Report& report) {
    const bool is_a = is_z_up(a.source), is_b = is_z_up(b.source);
    if (is_a == is_b) return {};
    if (up_axis(is_a ? b.source : a.source) == UpAxis::open) return UpAxis::z;
    Scene& lying = is_a ? a : b;
    lying = with_y_up(std::move(lying), lying.source, report);
    return UpAxis::y;
}

}  // namespace rakelight
