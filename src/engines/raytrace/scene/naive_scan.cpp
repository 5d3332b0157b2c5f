// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/scene/naive_scan.h"

#include <cmath>

#include "math/linear.h"

namespace rakelight::raytrace {
namespace {

/// Where a ray hits a triangle; NaN: nowhere. Möller & Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection".
/// @param normal  out: by the order of the corners, of any length
double meet_triangle(const vec3* corner, dvec3 origin, dvec3 direction, dvec3& normal) {
    const dvec3 a = cast<double>(corner[0]), e1 = cast<double>(corner[1]) - a, e2 = cast<double>(corner[2]) - a;
    const dvec3 p = cross(direction, e2);
    const double determinant = dot(e1, p);
    if (determinant == 0) return NAN;
    const dvec3 from = origin - a, q = cross(from, e1);
    const double u = dot(from, p) / determinant, v = dot(direction, q) / determinant;
    if (!(u >= 0 && v >= 0 && u + v <= 1)) return NAN;
    normal = cross(e1, e2);
    return dot(e2, q) / determinant;
}

}  // namespace

NaiveScan::NaiveScan(const shading::DrawList& list, const RayScene& rays, Context& context) : rays_(rays) {
    std::uint64_t count = 0;
    for (std::uint32_t d = 0; d < list.draws.size(); ++d)
        if (!rays.shape_of(d)) count += list.scene.meshes[list.draws[d].mesh].triangle_count();
    charge_ = MemoryCharge(context.memory(), 3 * sizeof(vec3) * count, "rays");
    corners_.reserve(3 * count);
    for (std::uint32_t d = 0; d < list.draws.size(); ++d) {
        if (rays.shape_of(d)) {
            shapes_.push_back(d);
            continue;
        }
        const Mesh& mesh = list.scene.meshes[list.draws[d].mesh];
        const dmat4 to_rays = translation(-rays.origin()) * list.draws[d].to_world;
        draws_.push_back(d), first_.push_back(std::uint32_t(corners_.size() / 3));
        for (const std::uint32_t i : mesh.indices)
            corners_.push_back(cast<float>(transform_point(to_rays, cast<double>(mesh.positions[i]))));
        context.throw_if_cancelled();
    }
}

Meeting NaiveScan::first(vec3 origin, vec3 direction, float from, float to, const RayFilter* wanted) const {
    Meeting nearest;
    nearest.t = to;
    const dvec3 o = cast<double>(origin), d = cast<double>(direction);
    tests_ += triangles() + shapes_.size();
    const auto offer = [&](const Meeting& m) {
        if (m.t > from && m.t < nearest.t && (!wanted || wanted->counts(m))) nearest = m;
    };
    for (std::size_t i = 0; i < draws_.size(); ++i) {
        const std::uint32_t end = i + 1 < first_.size() ? first_[i + 1] : std::uint32_t(triangles());
        for (std::uint32_t k = first_[i]; k < end; ++k) {
            dvec3 normal;
            const double t = meet_triangle(corners_.data() + 3 * std::size_t(k), o, d, normal);
            if (t > double(from) && t < double(nearest.t))
                offer({draws_[i], k - first_[i], float(t), dot(normal, d) < 0});
        }
    }
    for (const std::uint32_t draw : shapes_) {
        const Meeting m = first_on_shape(*rays_.shape_of(draw), origin, direction, from, nearest.t, wanted);
        if (m.draw != no_index) nearest = m;
    }
    return nearest.draw == no_index ? Meeting{} : nearest;
}

}  // namespace rakelight::raytrace
