// SPDX-License-Identifier: Apache-2.0
// Shadow maps: how much of a light reaches a run of pixels. Percentage-closer filtering (Reeves, Salesin & Cook 1987,
// "Rendering Antialiased Shadows with Depth Maps"), each texel compared with the plane of the pixel's triangle there
// (Isidoro 2006, "Shadow Mapping: GPU-based Tips and Techniques": receiver plane depth bias), which is pushed out along
// its normal by a part of a texel: towards a light at a grazing angle that is as much more as the plane is steeper. How
// far planes are carried on is bounded by what the texels round the pixel show: a rule of our own. Per instruction set.
#pragma once
#include "engines/raster/kernels/surface.h"

namespace rakelight::raster::RL_ISA {

/// Normal of the triangle's plane, unit, on the side that is seen: from the plane of 1 / w (or of the depth) over the
/// screen. `otherwise` where the plane is seen from its edge.
inline vec3 plane_normal(const ShadeJob& job, const Pixels& p, vec3 otherwise) {
    real dx, dy, at;
    p.records.each<3>(offsetof(ShadeTriangle, depth), [&](int k, const part::real(&plane)[3]) {
        part_of(dx, k) = plane[0], part_of(dy, k) = plane[1], part_of(at, k) = plane[2];
    });
    const float(&r)[3][3] = job.ray;
    const vec3 x = vec3(real(r[0][0]), real(r[1][0]), real(r[2][0])),
               y = vec3(real(r[0][1]), real(r[1][1]), real(r[2][1])),
               first = vec3(real(r[0][2]), real(r[1][2]), real(r[2][2]));
    if (job.orthographic != 0) {  // two ways along the plane
        const vec3 back = splat(job.view_direction);
        const vec3 n = safe_normalize_or(cross(y - back * dy, x - back * dx), otherwise);
        return n * select(dot(n, back) < real(0.0f), real(-1.0f), real(1.0f));
    }
    // n . ray = 1 / w at all pixels, so n . position = 1: n points away from the eye.
    const vec3 yf = cross(y, first);
    const real per_volume = reciprocal(dot(x, yf));
    const vec3 n = (yf * dx + cross(first, x) * dy + cross(x, y) * at) * per_volume;
    return -safe_normalize_or(n, -otherwise);
}

/// A vector in the axes of a map: x to the right, y up, z the way it looks.
struct MapFace {
    mask along_x, along_y, is_negative;  ///< about a point light, the largest component of the way from it
    real number;
};

inline MapFace face_of(vec3 from_light) {
    MapFace face;
    const real x = abs(from_light.x), y = abs(from_light.y), z = abs(from_light.z);
    face.along_x = (x >= y) & (x >= z);
    face.along_y = y >= z;
    const real largest = select(face.along_x, from_light.x, select(face.along_y, from_light.y, from_light.z));
    face.is_negative = largest < real(0.0f);
    face.number = select(face.along_x, real(0.0f), select(face.along_y, real(2.0f), real(4.0f))) +
                  select(face.is_negative, real(1.0f), real(0.0f));
    return face;
}

/// The axes of shadow_maps.cpp: cube.
inline vec3 to_face(const MapFace& face, vec3 v) {
    const real sign = select(face.is_negative, real(-1.0f), real(1.0f));
    const real right = select(face.along_x, v.z, select(face.along_y, v.x, -v.x)) * sign;
    const real up = select(face.along_x, v.y, select(face.along_y, v.z, v.y));
    const real ahead = select(face.along_x, v.x, select(face.along_y, v.y, v.z)) * sign;
    return vec3(right, up, ahead);
}

inline vec3 turned(const ShadowView& s, vec3 v) {
    const auto row = [&](int i) {
        return real(s.to_light[i][0]) * v.x + real(s.to_light[i][1]) * v.y + real(s.to_light[i][2]) * v.z;
    };
    return vec3(row(0), row(1), row(2));
}

/// Where a pixel lies on the map, and the plane of its triangle there.
struct OnMap {
    real x, y;                    ///< [texels] 0.5: the middle of the first one
    real nearness, per_x, per_y;  ///< at x, y, and its change per texel
    real first;                   ///< texel of the face
    real cosine;                  ///< between the plane's normal and the way to the light
};

inline OnMap find_on_map(const ShadowView& s, vec3 position, vec3 normal) {
    vec3 at = turned(s, position) + vec3(real(s.to_light[0][3]), real(s.to_light[1][3]), real(s.to_light[2][3]));
    vec3 n = turned(s, normal);
    OnMap out;
    out.first = real(0.0f);
    if (s.faces == 6) {
        const MapFace face = face_of(at);
        at = to_face(face, at);
        n = to_face(face, n);
        out.first = face.number;
    }
    const bool parallel = s.is_orthographic != 0;
    const real ahead = parallel ? real(1.0f) : max(at.z, real(1e-18f));
    at = at + n * (real(0.5f * s.bias / s.texels) * ahead);
    const real w = parallel ? real(1.0f) : max(at.z, real(1e-18f)), per_w = reciprocal(w);
    const real away = parallel ? real(1.0f) : max(length(at), real(1e-18f));
    out.cosine = -(parallel ? n.z : dot(n, at)) / away;
    const real least = max(abs(out.cosine), real(1e-3f));
    const real steep = select(out.cosine < real(0.0f), least, -least) * away;
    const real per_texel = reciprocal(steep * real(s.texels));
    out.x = real(0.5f * float(s.size)) + at.x * per_w * real(s.texels);
    out.y = real(0.5f * float(s.size)) - at.y * per_w * real(s.texels);
    out.nearness = parallel ? -at.z : per_w;
    out.per_x = n.x * per_texel;
    out.per_y = -(n.y * per_texel);
    return out;
}

/// How steep the surface is that a texel shows: depth per texel to the right and down, in widths of a texel there.
struct Slopes {
    real x, y;
};

inline Slopes slopes_of(const ShadowView& s, integer texel) {
    const integer code = gather_i(s.slopes, texel);
    const real scale(1.0f / slope_codes), most(steepest_slope_on_map);
    return {to_real(code & integer(0xffff)) * scale - most, to_real(shift_right_logical(code, 16)) * scale - most};
}

/// The width of a texel, as a step in nearness, at a surface of this nearness.
inline real width_at(const ShadowView& s, real nearness) {
    return real(1.0f / s.texels) * (s.is_orthographic != 0 ? real(1.0f) : nearness);
}

/// What one texel says of a pixel.
struct Tap {
    mask free;     ///< nothing covers the pixel, whatever planes do between the two
    real carried;  ///< 0..1: the same if both surfaces go on until their planes meet
    mask shows;    ///< it shows the pixel's own surface, or one that meets it
};

/// The pixel's plane is carried on to the texel; where the texel's surface is before it, and near, that one's plane to
/// the pixel: behind it, the surfaces meet between the two. The line along which they would is a texel wide.
/// @param x, y      [texels] from the pixel to the texel's middle
/// @param is_steep  the pixel's plane is steeper than steepest_slope_on_map
inline Tap compare_with(const ShadowView& s, const OnMap& m, mask is_steep, integer texel, real x, real y) {
    const bool parallel = s.is_orthographic != 0;
    const real zero(0.0f), one(1.0f), most(steepest_slope_on_map), nothing(parallel ? -3.4e38f : 0.0f);
    const real reach(2.0f * steepest_slope_on_map * float(s.filter + 1) / s.texels);
    const real there = gather(s.nearness, texel), rise = m.per_x * x + m.per_y * y;
    const mask before = there > max(m.nearness + rise, nothing);  // nothing is farther than nothing
    Tap out{!before, select(before, zero, one), !before};
    if (any_lane(is_steep)) {
        const real width = width_at(s, m.nearness), per_width = -reciprocal(width), like(0.25f);
        const real bounded = min(rise, most * (abs(x) + abs(y)) * width);
        out.free = there <= max(m.nearness + select(is_steep, bounded, rise), nothing);
        const Slopes t = slopes_of(s, texel);
        const mask is_parallel = (abs(t.x - clamp(m.per_x * per_width, -most, most)) < like) &
                                 (abs(t.y - clamp(m.per_y * per_width, -most, most)) < like);
        out.shows = out.free | (out.shows & is_parallel);
    }
    const mask is_near = before & (there - m.nearness < (parallel ? reach : there * reach));
    if (any_lane(is_near)) {
        const Slopes t = slopes_of(s, texel);
        const real width = width_at(s, there);
        const real behind = m.nearness - there - (t.x * x + t.y * y) * width;
        const real texels_behind = behind * reciprocal(width * (abs(t.x) + abs(t.y) + one));
        out.carried = select(is_near, clamp(one + texels_behind, zero, one), out.carried);
        out.shows = out.shows | (is_near & (behind >= zero));
    }
    return out;
}

/// Share of a square of 2 filter + 1 texels about the pixel that nothing covers. A texel's surface covers the pixel
/// where it lies before the pixel's plane there, and, carried on to the pixel, before the pixel itself: floors and
/// walls that meet do not darken each other along the edge. Both may end before they meet. So the planes count as much
/// as the four texels round the pixel show it: where none does, deep in a shadow, the pixel's plane rises by
/// steepest_slope_on_map at most (the facets of rough ground are steep and small), and no texel's is carried on.
inline real uncovered(const ShadowView& s, const OnMap& m) {
    const real last(float(s.size - 1)), zero(0.0f), one(1.0f);
    const real x = clamp(m.x - real(0.5f), zero, last), y = clamp(m.y - real(0.5f), zero, last);
    const real left = floor(x), top = floor(y), fx = x - left, fy = y - top;
    const int32_t r = s.filter, taps = 2 * r + 2;
    const integer face = to_int(m.first) * integer(s.size * s.size);
    const real steepest = width_at(s, m.nearness) * real(steepest_slope_on_map);
    const mask is_steep = (abs(m.per_x) > steepest) | (abs(m.per_y) > steepest);
    real carried = zero, free = zero, shown = zero;
    for (int32_t j = 0; j < taps; ++j) {
        const real row = real(float(j - r));
        const integer begin = face + to_int(clamp(top + row, zero, last)) * integer(s.size);
        const real weight_y = j == 0 ? one - fy : j == taps - 1 ? fy : one;
        for (int32_t i = 0; i < taps; ++i) {
            const real column = real(float(i - r));
            const integer texel = begin + to_int(clamp(left + column, zero, last));
            const Tap tap = compare_with(s, m, is_steep, texel, column - fx, row - fy);
            const real weight = (i == 0 ? one - fx : i == taps - 1 ? fx : one) * weight_y;
            carried = carried + tap.carried * weight;
            free = free + select(tap.free, weight, zero);
            if ((i == r || i == r + 1) && (j == r || j == r + 1)) {
                const real share = (i == r ? one - fx : fx) * (j == r ? one - fy : fy);
                shown = shown + select(tap.shows, share, zero);
            }
        }
    }
    const float side = float(2 * r + 1);
    return (free + (carried - free) * shown) * real(1.0f / (side * side));
}

/// 0..1: how much of light i arrives. Faces that look away from the light have none: down to where the normals of
/// neighbors, by which curved surfaces are lit, can differ from theirs, it fades.
inline real shadow_factor(const ShadeJob& job, int32_t i, const Pixels& p, const lit::LightSample&) {
    const int32_t map = job.lights[i].shadow;
    if (job.full->shadows == nullptr || map < 0) return real(1.0f);
    const ShadowView& s = job.full->shadows[map];
    const OnMap m = find_on_map(s, p.position, plane_normal(job, p, to_viewer(job, p.position)));
    const real fade = clamp(real(1.0f) + real(5.0f) * m.cosine, real(0.0f), real(1.0f));
    return uncovered(s, m) * fade;
}

}  // namespace rakelight::raster::RL_ISA
