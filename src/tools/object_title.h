// SPDX-License-Identifier: Apache-2.0
// What an object is called in tables.
#pragma once
#include <string>

#include <rakelight/io/world.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// A node's name; of what a world file places, after the name that it has there: "helmet/visor". Empty: it has none.
inline std::string object_title(const Scene& scene, std::uint32_t node) {
    const std::string& own = scene.nodes[node].name;
    std::uint32_t root = node;
    while (scene.nodes[root].parent != no_index) root = scene.nodes[root].parent;
    const std::string& part = scene.nodes[root].name;
    if (root == node || part.empty() || !is_world_file(scene.source)) return own;
    if (own.empty()) return part + "/node " + std::to_string(node);
    const bool is_the_part = own == part || own.starts_with(part + " ");  // "lid" does not belong to an "l"
    return is_the_part ? own : part + "/" + own;
}

}  // namespace rakelight
