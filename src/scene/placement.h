// SPDX-License-Identifier: Apache-2.0
// Where the things of a scene are in world space.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/scene/scene.h>
#include <rakelight/scene/scene_queries.h>

namespace rakelight {

/// Matrices node -> world, [nodes]. A single pass, because parents precede children.
std::vector<dmat4> world_matrices(const Scene& scene);

/// Triangles of all objects; each instance counts.
std::uint64_t triangle_count(const Scene& scene);

/// camera -> world of a camera of this scene, placed by a node or by its matrix, without scale.
dmat4 camera_to_world(const Scene& scene, const Camera& camera, const std::vector<dmat4>& world);

}  // namespace rakelight
