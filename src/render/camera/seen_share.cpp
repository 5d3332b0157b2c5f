// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "math/functions.h"
#include "math/linear.h"
#include "render/look.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

/// The part of space in a camera's picture, ignoring occlusion.
class Frustum {
public:
    Frustum(const Camera& camera, double aspect)
        : camera_(camera), parallel_(camera.projection == Projection::orthographic) {
        half_height_ = parallel_ ? camera.half_height : math::tan(0.5 * camera.vertical_fov_rad);
        half_width_ = half_height_ * aspect;
        if (parallel_ && camera.half_width) half_width_ = *camera.half_width;
        if (!parallel_ && camera.horizontal_fov_rad) half_width_ = math::tan(0.5 * *camera.horizontal_fov_rad);
    }
    bool has(dvec3 place) const {
        const dvec3 p = place - camera_.to_world[3].xyz();
        const double x = dot(p, camera_.to_world[0].xyz()), y = dot(p, camera_.to_world[1].xyz());
        const double depth = -dot(p, camera_.to_world[2].xyz()), at_one = parallel_ ? 1 : depth;
        return depth >= camera_.z_near && depth <= camera_.z_far && std::fabs(x) <= half_width_ * at_one &&
               std::fabs(y) <= half_height_ * at_one;
    }

private:
    const Camera& camera_;
    bool parallel_;
    double half_width_, half_height_;
};

struct Share {
    double seen = 0, all = 0;
    void add(double amount, bool is_seen) {
        if (!std::isfinite(amount)) return;
        all += amount;
        if (is_seen) seen += amount;
    }
};

void add_triangles(Share& share, const Mesh& mesh, const dmat4& to_world, const Frustum& frustum) {
    const dmat4 m = to_world * translation(mesh.origin);
    const auto place = [&](std::size_t i) { return transform_point(m, cast<double>(mesh.positions[mesh.indices[i]])); };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const dvec3 a = place(i), b = place(i + 1), c = place(i + 2);
        share.add(length(cross(b - a, c - a)), frustum.has((a + b + c) * (1.0 / 3)));
    }
}

void add_vertices(Share& share, const Mesh& mesh, const dmat4& to_world, const Frustum& frustum) {
    const dmat4 m = to_world * translation(mesh.origin);
    for (const std::uint32_t v : mesh.indices)
        share.add(1, frustum.has(transform_point(m, cast<double>(mesh.positions[v]))));
}

}  // namespace

double seen_share(const Scene& scene, const Camera& camera, double aspect) {
    const Frustum frustum(camera, aspect);
    const std::vector<dmat4> world = world_matrices(scene);
    Share surface, rest;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        for (const std::uint32_t number : scene.nodes[i].meshes) {
            const Mesh& mesh = scene.meshes[number];
            if (mesh.topology == Topology::triangles)
                add_triangles(surface, mesh, world[i], frustum);
            else
                add_vertices(rest, mesh, world[i], frustum);
        }
    const Share& counted = surface.all > 0 ? surface : rest;
    return counted.all > 0 ? counted.seen / counted.all : 0;
}

}  // namespace rakelight
