// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/geometry/clip.h"

#include <cmath>
#include <limits>
#include <utility>

#include "shading/guard_band.h"

namespace rakelight::raster {
namespace {

/// Signed distance to a plane, in any scale; >= 0 inside.
double inside_by(const ClipVertex& v, unsigned plane, const ClipVolume& volume) {
    const double x = v.x, y = v.y, w = v.w;
    switch (plane) {
        case clip_near:
            return double(v.distance) - volume.z_near;
        case clip_far:
            return volume.z_far - double(v.distance);
        case clip_left:
            return w + x;
        case clip_right:
            return w - x;
        case clip_bottom:
            return w + y;
        case clip_top:
            return w - y;
        case clip_guard_left:
            return double(volume.guard_x) * w + x;
        case clip_guard_right:
            return double(volume.guard_x) * w - x;
        case clip_guard_bottom:
            return double(volume.guard_y) * w + y;
        default:
            return double(volume.guard_y) * w - y;
    }
}

ClipVertex cut(const ClipVertex& inner, const ClipVertex& outer, double inner_by, double outer_by) {
    // From the nearer end, so that nothing cancels: a far corner at 1e20 must not blur where the near plane is.
    const bool from_inner = inner_by <= -outer_by;
    const double t = (from_inner ? inner_by : -outer_by) / (inner_by - outer_by);
    const auto mix = [t, from_inner](float a, float b) {
        return from_inner ? float(double(a) + (double(b) - double(a)) * t)
                          : float(double(b) + (double(a) - double(b)) * t);
    };
    return {mix(inner.x, outer.x), mix(inner.y, outer.y), mix(inner.w, outer.w), mix(inner.distance, outer.distance)};
}

std::size_t clip_by_plane(const ClipVertex* in, std::size_t count, ClipVertex* out, unsigned plane,
                          const ClipVolume& volume) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const ClipVertex &a = in[i], &b = in[(i + 1) % count];
        const double a_by = inside_by(a, plane, volume), b_by = inside_by(b, plane, volume);
        if (a_by >= 0) out[kept++] = a;
        if (a_by >= 0 && b_by < 0) out[kept++] = cut(a, b, a_by, b_by);
        if (a_by < 0 && b_by >= 0) out[kept++] = cut(b, a, b_by, a_by);
    }
    return kept;
}

}  // namespace

ClipVolume::ClipVolume(const PictureCamera& view)
    : z_near(view.z_near),
      z_far(view.z_far),
      guard_x(shading::GuardBand(view).x),
      guard_y(shading::GuardBand(view).y) {}

unsigned outcode(const ClipVertex& v, const ClipVolume& volume) {
    // Written so that a comparison with NaN counts as outside. kernels/vertex_kernel.h has the same once more.
    const float x = v.x, y = v.y, w = v.w, gx = volume.guard_x * w, gy = volume.guard_y * w;
    unsigned code = 0;
    if (!(v.distance >= volume.z_near)) code |= clip_near;
    if (!(v.distance <= volume.z_far)) code |= clip_far;
    if (!(x >= -w)) code |= clip_left;
    if (!(x <= w)) code |= clip_right;
    if (!(y >= -w)) code |= clip_bottom;
    if (!(y <= w)) code |= clip_top;
    if (!(x >= -gx)) code |= clip_guard_left;
    if (!(x <= gx)) code |= clip_guard_right;
    if (!(y >= -gy)) code |= clip_guard_bottom;
    if (!(y <= gy)) code |= clip_guard_top;
    const bool finite = std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.w) && std::isfinite(v.distance);
    return finite ? code : unsigned(outside_all);
}

std::size_t clip_triangle(const ClipVertex (&triangle)[3], unsigned planes, const ClipVolume& volume,
                          ClipVertex (&out)[max_clipped_vertices]) {
    ClipVertex other[max_clipped_vertices];
    ClipVertex *from = out, *to = other;
    std::size_t count = 3;
    for (std::size_t i = 0; i < 3; ++i) from[i] = triangle[i];
    // The near plane comes first: after it every w is positive.
    for (const unsigned plane :
         {clip_near, clip_far, clip_guard_left, clip_guard_right, clip_guard_bottom, clip_guard_top}) {
        if (!(planes & plane)) continue;
        count = clip_by_plane(from, count, to, plane, volume);
        std::swap(from, to);
        if (count < 3) return 0;
    }
    if (from != out)
        for (std::size_t i = 0; i < count; ++i) out[i] = from[i];
    return count;
}

}  // namespace rakelight::raster
