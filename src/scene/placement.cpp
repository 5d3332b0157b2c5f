// SPDX-License-Identifier: Apache-2.0
// World matrices of nodes, the bounding box, camera frames.
#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "math/linear.h"
#include "scene/scene_tools.h"

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

namespace {

/// 1 for every vertex that a triangle, line or point uses: unused vertices must not affect the camera.
std::vector<std::uint8_t> used_vertices(const Mesh& mesh) {
    std::vector<std::uint8_t> used(mesh.positions.size(), 0);
    for (const std::uint32_t index : mesh.indices) used[index] = 1;
    return used;
}

void extend(Bounds& bounds, const Mesh& mesh, const std::vector<std::uint8_t>& used, const dmat4& to_world) {
    const dmat4 m = to_world * translation(mesh.origin);
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (!used[v]) continue;
        const dvec3 p = transform_point(m, cast<double>(mesh.positions[v]));
        if (!is_finite(p)) continue;
        bounds.low = min(bounds.low, p);
        bounds.high = max(bounds.high, p);
    }
}

/// The largest dot products of places, for directions that are given in the mesh's own space.
void extend_reach(const Mesh& mesh, const std::vector<std::uint8_t>& used, std::span<const dvec3> directions,
                  std::span<const double> shift, std::span<double> reach) {
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (!used[v]) continue;
        const dvec3 p = cast<double>(mesh.positions[v]);
        for (std::size_t k = 0; k < directions.size(); ++k) {
            const double along = dot(p, directions[k]) + shift[k];
            if (along > reach[k] && std::isfinite(along)) reach[k] = along;
        }
    }
}

/// Calls f(mesh, used, matrix) for every object that is drawn.
template <class F>
void for_each_drawn(const Scene& scene, const F& f) {
    const std::vector<dmat4> world = world_matrices(scene);
    std::vector<std::vector<std::uint8_t>> used(scene.meshes.size());
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        for (const std::uint32_t number : scene.nodes[i].meshes) {
            const Mesh& mesh = scene.meshes[number];
            if (used[number].empty()) used[number] = used_vertices(mesh);
            f(mesh, used[number], world[i]);
        }
}

}  // namespace

Bounds world_bounds(const Scene& scene) {
    Bounds bounds;
    for_each_drawn(scene, [&](const Mesh& mesh, const std::vector<std::uint8_t>& used, const dmat4& to_world) {
        extend(bounds, mesh, used, to_world);
    });
    return bounds;
}

void farthest_along(const Scene& scene, dvec3 about, std::span<const dvec3> directions, std::span<double> reach) {
    RL_ASSERT(directions.size() == reach.size(), "a result for each direction");
    std::fill(reach.begin(), reach.end(), -HUGE_VAL);
    std::vector<dvec3> own(directions.size());
    std::vector<double> shift(directions.size());
    for_each_drawn(scene, [&](const Mesh& mesh, const std::vector<std::uint8_t>& used, const dmat4& to_world) {
        const dmat4 m = to_world * translation(mesh.origin);
        for (std::size_t k = 0; k < own.size(); ++k) {
            const dvec3 d = directions[k];
            own[k] = {dot(m[0].xyz(), d), dot(m[1].xyz(), d), dot(m[2].xyz(), d)};
            shift[k] = dot(m[3].xyz() - about, d);
        }
        extend_reach(mesh, used, own, shift, reach);
    });
    for (double& r : reach)
        if (r == -HUGE_VAL) r = 0;
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
