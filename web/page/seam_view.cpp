// SPDX-License-Identifier: Apache-2.0
#include "seam_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <rakelight/math/linear.h>

namespace rakelight::web {
namespace {

constexpr double distance_share = 0.35;  // of the model's size: from the eye to the seam
constexpr double light_deg = 14;         // of the light above the surface
constexpr double tilt = 0.5;             // of the eye, off the normal

using Triangle = std::array<dvec3, 3>;

/// In the world, with the number of its mesh.
void each_triangle(const Scene& scene, const std::function<void(std::uint32_t, const Triangle&)>& call) {
    const std::vector<dmat4> world = viewer::node_matrices(scene);
    for (std::size_t n = 0; n < scene.nodes.size(); ++n)
        for (const std::uint32_t m : scene.nodes[n].meshes) {
            const Mesh& mesh = scene.meshes[m];
            for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
                Triangle corners;
                for (std::size_t k = 0; k < 3; ++k)
                    corners[k] = viewer::position_in_world(world[n], mesh, mesh.indices[3 * t + k]);
                call(m, corners);
            }
        }
}

dvec3 area_normal(const Triangle& t) { return cross(t[1] - t[0], t[2] - t[0]); }

/// The distance along a ray at which it meets the triangle, or infinity (Moeller & Trumbore 1997).
double hit(const Triangle& t, dvec3 from, dvec3 direction) {
    constexpr double none = std::numeric_limits<double>::infinity();
    const dvec3 e1 = t[1] - t[0], e2 = t[2] - t[0], p = cross(direction, e2), s = from - t[0], q = cross(s, e1);
    const double det = dot(e1, p);
    if (det == 0) return none;
    const double u = dot(s, p) / det, v = dot(direction, q) / det, d = dot(e2, q) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && d > 0 ? d : none;
}

/// How far each of some directions is free of surfaces, at most `most`. Surfaces that begin at the place do not count.
std::vector<double> free_distances(const Scene& scene, dvec3 place, std::span<const dvec3> directions, double most) {
    std::vector<double> free(directions.size(), most);
    const double lift = 0.02 * most;
    each_triangle(scene, [&](std::uint32_t, const Triangle& t) {
        for (std::size_t i = 0; i < directions.size(); ++i)
            free[i] = std::min(free[i], lift + hit(t, place + directions[i] * lift, directions[i]));
    });
    return free;
}

/// The seam line that ends nearest to a place, and its direction; unit, or zero.
dvec3 direction_of_border(std::span<const SeamLine> seams, dvec3 place) {
    const auto away = [&](const SeamLine& s) { return std::min(length(s.a - place), length(s.b - place)); };
    const auto nearest = std::ranges::min_element(seams, {}, away);
    return nearest == seams.end() ? dvec3{} : normalize_or(nearest->b - nearest->a, dvec3{});
}

}  // namespace

SeamView view_of_seam(const ExaminedModel& model, std::size_t border) {
    const Inspection& found = model.inspection;
    if (border >= found.borders.size()) throw Error(ErrorCode::usage, "there is no such border");
    const BorderSummary& of = found.borders[border];
    const Scene& scene = model.model->scene;
    const dvec3 place = of.seam_position;
    const double size = std::max(length(found.high - found.low), 1e-9), near = 1e-6 * size;
    dvec3 sum{};
    each_triangle(scene, [&](std::uint32_t mesh, const Triangle& t) {
        const bool is_there = std::ranges::any_of(t, [&](dvec3 p) { return length(p - place) <= near; });
        if (is_there && (mesh == of.mesh_a || mesh == of.mesh_b)) sum += area_normal(t);
    });
    const dvec3 outward = normalize_or(place - (found.low + found.high) * 0.5, dvec3{0, 0, 1});
    const dvec3 normal = normalize_or(sum, outward), border_line = direction_of_border(model.seams, place);
    const dvec3 along = normalize_or(border_line - normal * dot(border_line, normal),
                                     normalize_or(cross(normal, dvec3{0.31, 1, 0.17}), dvec3{1, 0, 0}));
    const dvec3 across = cross(normal, along);
    std::vector<dvec3> directions{normal};
    for (const dvec3 by : {along, -along, across, -across})
        directions.push_back(normalize_or(normal + by * tilt, normal));
    for (const dvec3 by : {along, -along, across, -across})
        directions.push_back(normalize_or(normal + by * 2.0, normal));
    const std::vector<double> free = free_distances(scene, place, directions, distance_share * size);
    const auto best = std::size_t(std::ranges::max_element(free) - free.begin());
    const double low = radians(light_deg);
    return {place, place + directions[best] * (0.9 * free[best]), across * std::cos(low) + normal * std::sin(low)};
}

}  // namespace rakelight::web
