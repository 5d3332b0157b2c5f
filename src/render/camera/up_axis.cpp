// SPDX-License-Identifier: Apache-2.0
#include "render/camera/up_axis.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <rakelight/scene/scene_queries.h>
#include <rakelight_internal/base/file_ending.h>

#include "math/linear.h"
#include "scene/drawn_vertices.h"
#include "scene/placement.h"
#include "world/z_up.h"

namespace rakelight {
namespace {

constexpr double slab = 0.01;                 ///< of the box's extent, that counts as its side
constexpr double least_share = 0.25;          ///< of a side of the box, that is a base
constexpr double least_ratio = 3;             ///< of a base to all other sides
constexpr double most_lean = 0.985;           ///< cosine to the axis: 10 degrees
constexpr double least_height = 0.25;         ///< over width and depth: flat boards hang on walls, too
constexpr std::uint64_t least_triangles = 6;  ///< fewer have no shape
constexpr double survey_distance = 10;        ///< in sizes of the model

/// [3 * axis end] Share of each side of the box that is filled by triangles which face along its axis: -x, +x, -y, ...
using SideShares = std::array<double, 6>;

void add_triangle(const dvec3 (&p)[3], const Bounds& box, SideShares& area) {
    const dvec3 n = cross(p[1] - p[0], p[2] - p[0]);
    const double length = std::sqrt(dot(n, n));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!(std::fabs(n[axis]) >= most_lean * length) || length == 0) continue;
        const double room = slab * (box.high[axis] - box.low[axis]);
        const auto all = [&](auto&& is_there) {
            return is_there(p[0][axis]) && is_there(p[1][axis]) && is_there(p[2][axis]);
        };
        if (all([&](double x) { return x <= box.low[axis] + room; })) area[2 * axis] += length / 2;
        if (all([&](double x) { return x >= box.high[axis] - room; })) area[2 * axis + 1] += length / 2;
    }
}

SideShares side_shares(const Scene& scene, const Bounds& box) {
    SideShares area{};
    const std::vector<dmat4> world = world_matrices(scene);
    for (std::size_t n = 0; n < scene.nodes.size(); ++n)
        for (const std::uint32_t m : scene.nodes[n].meshes) {
            const Mesh& mesh = scene.meshes[m];
            const dmat4 place = world[n] * translation(mesh.origin);
            for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
                dvec3 p[3];
                for (std::size_t k = 0; k < 3; ++k)
                    p[k] = transform_point(place, cast<double>(mesh.positions[mesh.indices[3 * t + k]]));
                add_triangle(p, box, area);
            }
        }
    const dvec3 size = box.high - box.low;
    const double sides[3] = {size.y * size.z, size.x * size.z, size.x * size.y};
    for (std::size_t s = 0; s < 6; ++s) area[s] = sides[s / 2] > 0 ? area[s] / sides[s / 2] : 0;
    return area;
}

/// @param axis  1: Y, 2: Z
bool stands_on_lowest(std::size_t axis, const Scene& scene, const Bounds& box) {
    const dvec3 size = box.high - box.low;
    const std::size_t other = 3 - axis;  // beside X
    if (!(size.x > 0 && size[other] > 0 && size[axis] >= least_height * std::max(size.x, size[other]))) return false;
    if (triangle_count(scene) < least_triangles) return false;
    const SideShares share = side_shares(scene, box);
    double others = 0;
    for (std::size_t s = 0; s < 6; ++s)
        if (s != 2 * axis) others = std::max(others, share[s]);
    return share[2 * axis] >= least_share && share[2 * axis] >= least_ratio * others;
}

}  // namespace

bool has_no_up_axis(const std::string& path) { return up_axis(path) != UpAxis::y || file_ending(path) == "obj"; }

std::string why_z_is_up(const Scene& scene) {
    const Bounds box = world_bounds(scene);
    if (box.empty()) return {};
    const dvec3 size = box.high - box.low, center = (box.low + box.high) * 0.5;
    const double diagonal = std::sqrt(dot(size, size));
    const auto is_far = [&](double x) { return std::fabs(x) > survey_distance * diagonal; };
    if (is_far(center.x) && is_far(center.y) && !is_far(center.z))
        return "its coordinates look like those of a survey, far from zero in x and y";
    return stands_on_lowest(2, scene, box) ? "it stands on a flat base at its lowest z" : "";
}

std::string why_y_is_up(const Scene& scene) {
    const Bounds box = world_bounds(scene);
    return !box.empty() && stands_on_lowest(1, scene, box) ? "it stands on a flat base at its lowest y" : "";
}

}  // namespace rakelight
