// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/surface_rays.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engines/raytrace/scene/ray_scene.h"
#include "math/isa.h"
#include "math/linear.h"

namespace rakelight::raytrace {
namespace {

Scene without_shapes(Scene scene) {
    for (Mesh& mesh : scene.meshes) mesh.shape.reset();
    return scene;
}

/// Barycentric coordinates of where a line meets a triangle's plane, clamped to the triangle; t along the line.
/// By Moeller & Trumbore 1997, in double: Embree's own are floats about its origin.
SurfaceHit meet(dvec3 from, dvec3 direction, const std::array<dvec3, 3>& p, double t_of_embree) {
    const dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0], h = cross(direction, e2), s = from - p[0], q = cross(s, e1);
    const double det = dot(e1, h);
    SurfaceHit hit;
    double u = 1.0 / 3, v = 1.0 / 3;
    hit.t = t_of_embree;
    if (det != 0) u = dot(s, h) / det, v = dot(direction, q) / det, hit.t = dot(e2, q) / det;
    u = std::clamp(u, 0.0, 1.0), v = std::clamp(v, 0.0, 1 - u);
    hit.weight[0] = 1 - u - v, hit.weight[1] = u, hit.weight[2] = v;
    return hit;
}

}  // namespace

struct SurfaceRays::Impl {
    explicit Impl(Isa isa) : rays(isa) {}
    shading::TextureCache textures;
    cpu_shading::DrawList list;
    RayScene rays;
};

/// By one instruction set: where a ray passes an edge, another one of Embree's may meet the other triangle. It costs bakes 15 %.
SurfaceRays::SurfaceRays(Scene scene, Context& context) : impl_(std::make_unique<Impl>(Isa::sse2)) {
    impl_->list = cpu_shading::make_draw_list(without_shapes(std::move(scene)), impl_->textures, context);
    impl_->rays.set(impl_->list, context);
}

SurfaceRays::~SurfaceRays() = default;

const cpu_shading::DrawList& SurfaceRays::list() const { return impl_->list; }

std::optional<SurfaceHit> SurfaceRays::first(dvec3 from, dvec3 direction, double least, double most) const {
    const dvec3 start = from - impl_->rays.origin();
    const Meeting meeting =
        impl_->rays.first(cast<float>(start), cast<float>(direction), float(least), float(most), nullptr);
    if (meeting.draw == no_index) return std::nullopt;
    const shading::Draw& draw = impl_->list.draws[meeting.draw];
    const Mesh& mesh = impl_->list.scene.meshes[draw.mesh];
    std::array<dvec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
        corners[k] = transform_point(draw.to_world,
                                     cast<double>(mesh.positions[mesh.indices[3 * std::size_t(meeting.triangle) + k]]));
    SurfaceHit hit = meet(from, direction, corners, meeting.t);
    hit.draw = meeting.draw, hit.triangle = meeting.triangle;
    return hit;
}

bool SurfaceRays::is_blocked(dvec3 from, dvec3 to, double margin) const {
    const dvec3 start = from - impl_->rays.origin(), way = to - from;
    return impl_->rays.is_blocked(cast<float>(start), cast<float>(way), float(margin), float(1 - margin), nullptr);
}

}  // namespace rakelight::raytrace
