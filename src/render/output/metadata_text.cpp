// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

#include <rakelight/scene/scene_queries.h>
#include <rakelight_internal/base/file_ending.h>

#include "render/output/overlay.h"
#include "scene/drawn_vertices.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

/// "1234567" as "1,234,567".
std::string with_separators(std::uint64_t count) {
    std::string digits = std::to_string(count);
    for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
    return digits;
}

std::string format_of(const std::string& file) {
    std::string ending = file_ending(file);
    if (ending.empty()) return file.starts_with("builtin:") ? "built in" : "unknown";
    std::ranges::transform(ending, ending.begin(), [](char c) { return c >= 'a' && c <= 'z' ? char(c - 32) : c; });
    return ending;
}

}  // namespace

std::string metadata_text(const std::string& file, const Scene& scene) {
    const auto objects = std::uint64_t(
        std::count_if(scene.nodes.begin(), scene.nodes.end(), [](const Node& n) { return !n.meshes.empty(); }));
    std::string text = "format " + format_of(file) + "\nobjects " + with_separators(objects) + "\ntriangles " +
                       with_separators(triangle_count(scene)) + "\nmaterials " +
                       with_separators(scene.materials.size()) + "\ntextures " + with_separators(scene.textures.size());
    const Bounds box = world_bounds(scene);
    if (box.empty()) return text;
    char size[100];
    std::snprintf(size, sizeof size, "\nsize %.4g x %.4g x %.4g", box.high.x - box.low.x, box.high.y - box.low.y,
                  box.high.z - box.low.z);
    return text + size;
}

}  // namespace rakelight
