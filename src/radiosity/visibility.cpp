// SPDX-License-Identifier: Apache-2.0
#include "radiosity/visibility.h"

#include <algorithm>
#include <cmath>

#include "math/linear.h"
#include "radiosity/form_factor.h"

namespace rakelight::radiosity {
namespace {

/// Distance, in bounding radii, beyond which a patch is treated as a small area: the error for a face-on disc is 2.8 %,
/// for others less.
constexpr double far_reaches = 6;
double of_small_area(const Receiver& r, dvec3 center, std::span<const dvec3> facets) {
    const dvec3 way = center - r.at;
    const double squared = dot(way, way), here = dot(r.normal, way);
    if (!(here > 0)) return 0;
    double there = 0;
    for (const dvec3 facet : facets) there += std::max(0.0, -dot(facet, way));
    return here * there / (pi * squared * squared);
}

/// Side length of the triangular ray pattern, by the importance of the light.
constexpr int max_rays_a_side = 4;
int rays_a_side(double share) { return share < 1e-3 ? 1 : share < 1e-2 ? 2 : share < 5e-2 ? 3 : max_rays_a_side; }

}  // namespace

double FormFactors::unblocked(const Receiver& r, const Patch& patch) const {
    const dvec3 way = patch.center - r.at;
    const bool is_far = dot(way, way) > far_reaches * far_reaches * patch.reach * patch.reach;
    // Patches cut by the receiver's horizon need more than their center, which may be below it.
    if (is_far && std::fabs(dot(r.normal, way)) >= patch.reach)
        return of_small_area(r, patch.center, patches_.facets_of(patch));
    if (dot(r.normal, way) <= -patch.reach) return 0;  // all below the horizon
    if (const std::span<const Patch> halves = patches_.halves_of(patch); !halves.empty())
        return std::min(unblocked(r, halves[0]) + unblocked(r, halves[1]), 1.0);
    double sum = 0;
    for (const std::uint32_t i : patches_.of(patch)) {
        const Element& e = elements_.list[i];
        if (dot(e.face_normal, r.at - e.corner[0]) > 0) sum += form_factor_of_triangle(r.at, r.normal, e.corner);
    }
    return std::min(sum, 1.0);
}

bool FormFactors::is_blocked(const Receiver& r, const Element& e, dvec3 to) const {
    return rays_.is_blocked(r.at + r.face_normal * gap_, to + e.face_normal * gap_, 1e-5);
}

/// The center of a triangle, or the centers of its n^2 sub-triangles; for patches of several triangles the centers of
/// n^2 of them.
double FormFactors::visible_share(const Receiver& r, const Patch& patch, int n) const {
    const std::span<const std::uint32_t> members = patches_.of(patch);
    int seen = 0, asked = 0;
    const auto ask = [&](const Element& e, dvec3 to) {
        if (dot(e.face_normal, r.at - to) <= 0 || dot(r.normal, to - r.at) <= 0) return;
        ++asked;
        seen += is_blocked(r, e, to) ? 0 : 1;
    };
    if (members.size() > 1) {
        const std::size_t count = std::min(members.size(), std::size_t(n * n));
        for (std::size_t i = 0; i < count; ++i) {
            const Element& e = elements_.list[members[(2 * i + 1) * members.size() / (2 * count)]];
            ask(e, e.center);
        }
    } else {
        const Element& e = elements_.list[members[0]];
        const dvec3 u = (e.corner[1] - e.corner[0]) / double(n), v = (e.corner[2] - e.corner[0]) / double(n);
        for (int i = 0; i < n; ++i)
            for (int j = 0; i + j < n; ++j) {
                ask(e, e.corner[0] + u * (i + 1.0 / 3) + v * (j + 1.0 / 3));
                if (i + j + 1 < n) ask(e, e.corner[0] + u * (i + 2.0 / 3) + v * (j + 2.0 / 3));
            }
    }
    if (asked == 0 && n < max_rays_a_side) return visible_share(r, patch, max_rays_a_side);  // above the horizon
    return asked > 0 ? double(seen) / asked : 0;
}

double FormFactors::operator()(const Receiver& r, std::uint32_t number, double weight) const {
    const Patch& patch = patches_.list[number];
    const double whole = unblocked(r, patch);
    if (!(whole > 0)) return 0;
    return whole * visible_share(r, patch, rays_a_side(whole * weight));
}

}  // namespace rakelight::radiosity
