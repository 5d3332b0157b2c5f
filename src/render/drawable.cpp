// SPDX-License-Identifier: Apache-2.0
#include "render/drawable.h"

#include <rakelight/base/error.h>

#include <algorithm>

#include "math/linear.h"
#include "prepare/moving_placements.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

/// Lines and points need only a position.
bool has_place(const Mesh& mesh) {
    return std::any_of(mesh.indices.begin(), mesh.indices.end(),
                       [&](std::uint32_t i) { return is_finite(mesh.positions[i]); });
}

bool can_be_seen(const Mesh& mesh, const dmat4& to_world) {
    if (mesh.topology != Topology::triangles) return has_place(mesh);
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

bool can_be_seen(const Scene& scene) {
    const std::vector<dmat4> world = world_matrices(scene);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        for (const std::uint32_t mesh : scene.nodes[i].meshes)
            // Skinned meshes are not placed by their node.
            if (can_be_seen(scene.meshes[mesh],
                            follows_skin(scene, scene.nodes[i], scene.meshes[mesh]) ? dmat4{} : world[i]))
                return true;
    return false;
}

void check_drawable(const Scene& scene) {
    if (!can_be_seen(scene))
        throw Error(ErrorCode::bad_file, "nothing to draw: no triangle has an area, and there are no lines or points")
            .with_file(scene.source);
}

}  // namespace rakelight
