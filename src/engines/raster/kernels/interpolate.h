// SPDX-License-Identifier: Apache-2.0
// Perspective-correct attributes of a run of pixels, and their analytic screen derivatives. Per instruction set.
#pragma once
#include "engines/raster/kernel_types.h"
#include "math/wide.h"

namespace rakelight::raster::RL_ISA {
RL_USE_WIDE;
namespace part = rakelight::wide::RL_WIDE_PART;
using rakelight::wide::RL_ISA::part_of;

/// Numbers of the triangles' records, one record a lane. Lanes of one triangle get them by one broadcast: a gather
/// would read lane by lane, and neighbors mostly share a triangle. Halves of a pair apart: they show different
/// triangles.
struct Records {
    static constexpr int parts = lanes / part::lanes;
    struct Part {
        int32_t count;  ///< of different triangles
        const float* base[part::lanes];
        part::mask lanes_of[part::lanes];
    };
    Part of[parts];

    Records() = default;
    /// Records of `floats` floats each.
    Records(const float* records, int32_t floats, const int32_t* triangle) { find(records, floats, triangle); }

    void find(const float* records, int32_t floats, const int32_t* triangle) {
        for (int p = 0; p < parts; ++p) find_part(records, floats, triangle + p * part::lanes, of[p]);
    }

    /// `n` numbers that follow one another.
    template <int n>
    void get(size_t member_offset, real* out) const {
        const int32_t at = int32_t(member_offset / sizeof(float));
        for (int p = 0; p < parts; ++p) get_part<n>(of[p], at, p, out);
    }
    real operator()(size_t member_offset) const {
        real one;
        get<1>(member_offset, &one);
        return one;
    }

private:
    static void find_part(const float* records, int32_t floats, const int32_t* triangle, Part& to) {
        const part::integer all = part::load_i(triangle);
        to.count = 1;
        to.base[0] = records + int64_t(triangle[0]) * floats;
        uint32_t others = part::lane_bits(all != part::integer(triangle[0]));
        while (others != 0) {
            const int32_t next = triangle[__builtin_ctz(others)];
            const part::mask same = all == part::integer(next);
            others &= ~part::lane_bits(same);
            to.base[to.count] = records + int64_t(next) * floats;
            to.lanes_of[to.count++] = same;
        }
    }
    template <int n>
    static void get_part(const Part& from, int32_t at, int p, real* out) {
        part::real v[n];
        for (int k = 0; k < n; ++k) v[k] = part::broadcast(from.base[0][at + k]);
        for (int32_t i = 1; i < from.count; ++i)
            for (int k = 0; k < n; ++k)
                v[k] = part::select(from.lanes_of[i], part::broadcast(from.base[i][at + k]), v[k]);
        for (int k = 0; k < n; ++k) part_of(out[k], p) = v[k];
    }
};

/// Where a pixel lies in its triangle, and how that changes from pixel to pixel: b0 = 1 - b1 - b2.
struct Barycentrics {
    real b1, b2;
    real b1_dx, b1_dy, b2_dx, b2_dy;
};

/// Barycentrics and depth of pixels.
struct Place {
    Barycentrics b;
    real depth;  ///< perspective: w; orthographic: the distance
};

inline Place place_of(const Records& r, real x, real y, bool affine, bool orthographic) {
    real plane[9];
    r.get<9>(offsetof(ShadeTriangle, b1), plane);
    const auto at = [&](int k) { return plane[k] * x + plane[k + 1] * y + plane[k + 2]; };
    Place p;
    const real d = at(6);
    p.depth = orthographic ? d : reciprocal(select(d > real(0.0f), d, real(1.0f)));
    real b1 = at(0), b2 = at(3);
    if (affine) {
        p.b.b1_dx = plane[0], p.b.b1_dy = plane[1];
        p.b.b2_dx = plane[3], p.b.b2_dy = plane[4];
    } else {
        const real w = p.depth;
        b1 = b1 * w, b2 = b2 * w;
        p.b.b1_dx = (plane[0] - b1 * plane[6]) * w;
        p.b.b1_dy = (plane[1] - b1 * plane[7]) * w;
        p.b.b2_dx = (plane[3] - b2 * plane[6]) * w;
        p.b.b2_dy = (plane[4] - b2 * plane[7]) * w;
    }
    // A pixel of a sliver may by rounding lie outside of it, and that would throw its attributes far out: they stay
    // inside.
    p.b.b1 = clamp(b1, real(0.0f), real(1.0f));
    p.b.b2 = clamp(b2, real(0.0f), real(1.0f) - p.b.b1);
    return p;
}

/// a0, a1 - a0, a2 - a0 -> the value at the pixel.
inline real interpolate(const real* a, const Barycentrics& b) { return a[0] + b.b1 * a[1] + b.b2 * a[2]; }

inline vec3 interpolate3(const Records& r, const Barycentrics& b, size_t member_offset) {
    real a[9];
    r.get<9>(member_offset, a);
    return vec3(interpolate(a, b), interpolate(a + 3, b), interpolate(a + 6, b));
}

inline vec4 interpolate_color(const Records& r, const Barycentrics& b) {
    real a[12];
    r.get<12>(offsetof(ShadeTriangle, color), a);
    return vec4(interpolate(a, b), interpolate(a + 3, b), interpolate(a + 6, b), interpolate(a + 9, b));
}

/// Texture coordinates with their change from pixel to pixel.
struct TexCoords {
    vec2 uv, dx, dy;
};

inline TexCoords texcoords(const Records& r, const Barycentrics& b, int set) {
    real a[6];
    r.get<6>(set == 0 ? offsetof(ShadeTriangle, texcoord0) : offsetof(ShadeTriangle, texcoord1), a);
    return {vec2(interpolate(a, b), interpolate(a + 3, b)),
            vec2(b.b1_dx * a[1] + b.b2_dx * a[2], b.b1_dx * a[4] + b.b2_dx * a[5]),
            vec2(b.b1_dy * a[1] + b.b2_dy * a[2], b.b1_dy * a[4] + b.b2_dy * a[5])};
}

}  // namespace rakelight::raster::RL_ISA
