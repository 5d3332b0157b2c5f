// SPDX-License-Identifier: Apache-2.0
// World matrices of nodes, boxes, camera frames.
#include <rakelight/scene/scene_queries.h>
#include <rakelight/scene/validate.h>

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "math/linear.h"
#include "scene/drawn_vertices.h"
#include "scene/placement.h"

namespace rakelight {

std::vector<dmat4> world_matrices(const Scene& scene) {
    std::vector<dmat4> world(scene.nodes.size());
    for (std::size_t i = 0; i < world.size(); ++i) {
        const Node& node = scene.nodes[i];
        const Transform& t = node.local;
        const dmat4 local = t.matrix ? *t.matrix : compose(t.translation, t.rotation, t.scale);
        RL_ASSERT(node.parent == no_index || node.parent < i, "a parent comes before its child");
        world[i] = node.parent == no_index ? local : world[node.parent] * local;
    }
    return world;
}

dvec3 Bounds::center() const { return empty() ? dvec3{0, 0, 0} : low * 0.5 + high * 0.5; }

double Bounds::diagonal() const {
    if (empty()) return 0;
    const dvec3 size = high * 0.5 - low * 0.5;  // halves: the difference itself may overflow
    const double largest = std::max({size.x, size.y, size.z});
    return largest > 0 ? std::min(2 * (largest * length(size / largest)), 1e300) : 0;
}

std::uint64_t triangle_count(const Scene& scene) {
    std::uint64_t count = 0;
    for (const Node& node : scene.nodes)
        for (const std::uint32_t mesh : node.meshes) count += scene.meshes[mesh].triangle_count();
    return count;
}

dmat4 camera_to_world(const Scene&, const Camera& camera, const std::vector<dmat4>& world) {
    RL_ASSERT(camera.node == no_index || camera.node < world.size(), "the camera's node exists");
    const dmat4& m = camera.node == no_index ? camera.to_world : world[camera.node];
    // Keeps the view direction, orthogonalizes the up direction and derives x, so that the result is a rotation even
    // for mirroring, shearing or singular matrices.
    const dvec3 x_axis = normalize_or(m[0].xyz(), dvec3{0, 0, 0}), y_axis = normalize_or(m[1].xyz(), dvec3{0, 0, 0});
    const dvec3 z = normalize_or(m[2].xyz(), normalize_or(cross(x_axis, y_axis), dvec3{0, 0, 1}));
    dvec3 y = y_axis - z * dot(y_axis, z);
    if (!(dot(y, y) > 1e-20)) y = cross(z, x_axis);
    if (!(dot(y, y) > 1e-20)) y = std::fabs(z.y) < 0.9 ? dvec3{0, 1, 0} - z * z.y : dvec3{1, 0, 0} - z * z.x;
    y = normalize_or(y, dvec3{0, 1, 0});
    y = normalize_or(y - z * dot(y, z), y);  // repeated, because the first difference may lose digits
    const dvec3 x = cross(y, z);
    const dvec3 eye = is_finite(m[3].xyz()) ? m[3].xyz() : dvec3{0, 0, 0};
    return {{{x.x, x.y, x.z, 0}, {y.x, y.y, y.z, 0}, {z.x, z.y, z.z, 0}, {eye.x, eye.y, eye.z, 1}}};
}

Bounds bounds(const Scene& scene) {
    validate(scene);
    return world_bounds(scene);
}

}  // namespace rakelight
