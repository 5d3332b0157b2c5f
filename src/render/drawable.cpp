// SPDX-License-Identifier: Apache-2.0
#include "render/drawable.h"

#include <rakelight/error.h>

#include <algorithm>

#include "math/linear.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

bool has_area(const Mesh& mesh, const dmat4& to_world) {
    if (mesh.topology != Topology::triangles) return false;
    const auto corner = [&](std::size_t i) {
        return transform_direction(to_world, cast<double>(mesh.positions[mesh.indices[i]]));
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const dvec3 a = corner(i), normal = cross(corner(i + 1) - a, corner(i + 2) - a);
        // The largest part, not the length: squares of it would vanish for very small models.
        if (std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)}) > 0 && is_finite(normal))
            return true;
    }
    return false;
}

}  // namespace

bool has_area(const Scene& scene) {
    const std::vector<dmat4> world = world_matrices(scene);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        for (const std::uint32_t mesh : scene.nodes[i].meshes)
            if (has_area(scene.meshes[mesh], world[i])) return true;
    return false;
}

void check_drawable(const Scene& scene) {
    if (!has_area(scene))
        throw Error(ErrorCode::bad_file, "nothing to draw: no triangle has an area").with_file(scene.source);
}

}  // namespace rakelight
