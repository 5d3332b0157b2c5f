// SPDX-License-Identifier: Apache-2.0
// Perspective-correct attributes of a run of pixels, and their analytic screen derivatives. Per instruction set.
#pragma once
#include "cpu_shading/kernels/shading_point.h"
#include "engines/raster/kernels/kernel_types.h"

namespace rakelight::raster::RL_ISA {
RL_USE_WIDE;
namespace lit = rakelight::lighting::RL_ISA;
using cpu_shading::RL_ISA::SignedVector, cpu_shading::RL_ISA::TexCoords;
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

    /// Calls use(part, a) with a[0] to a[n - 1], numbers that follow one another, of each part's triangles. What is made
    /// of them while they are in registers need not travel through memory.
    template <int n, class Use>
    void each(size_t member_offset, const Use& use) const {
        const int32_t at = int32_t(member_offset / sizeof(float));
#pragma GCC unroll 2
        for (int p = 0; p < parts; ++p) {  // what the parts make stays in registers
            part::real a[n];
            get(of[p], at, a);
            use(p, a);
        }
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
    static void get(const Part& from, int32_t at, part::real (&a)[n]) {
        for (int k = 0; k < n; ++k) a[k] = part::broadcast(from.base[0][at + k]);
        for (int32_t i = 1; i < from.count; ++i)
            for (int k = 0; k < n; ++k)
                a[k] = part::select(from.lanes_of[i], part::broadcast(from.base[i][at + k]), a[k]);
    }
};

/// Where a pixel lies in its triangle: b0 = 1 - b1 - b2. And what turns the slopes of its record into those at the
/// pixel: w, and the change of 1 / w per pixel in x and y; affine: 1, 0, 0.
struct Barycentrics {
    real b1, b2;
    real w, per_w_dx, per_w_dy;
};

/// Barycentrics and depth of pixels.
struct Place {
    Barycentrics b;
    real depth;  ///< perspective: w; orthographic: the distance
};

inline Place place_of(const Records& r, real x, real y, bool affine, bool orthographic) {
    Place place;
    Barycentrics& b = place.b;
    r.each<9>(offsetof(ShadeTriangle, b1), [&](int p, const part::real(&plane)[9]) {
        using part::max, part::min;
        const part::real zero(0.0f), one(1.0f);
        const auto at = [&](int k) { return plane[k] * part_of(x, p) + plane[k + 1] * part_of(y, p) + plane[k + 2]; };
        const part::real d = at(6), w = one / part::select(d > zero, d, one);
        part_of(place.depth, p) = orthographic ? d : w;
        part::real b1 = at(0), b2 = at(3);
        if (!affine) b1 = b1 * w, b2 = b2 * w;
        part_of(b.w, p) = affine ? one : w;
        part_of(b.per_w_dx, p) = affine ? zero : plane[6];
        part_of(b.per_w_dy, p) = affine ? zero : plane[7];
        // A pixel of a sliver may by rounding lie outside of it, and that would throw its attributes far out: they stay
        // inside.
        b1 = min(max(b1, zero), one);
        part_of(b.b1, p) = b1;
        part_of(b.b2, p) = min(max(b2, zero), one - b1);
    });
    return place;
}

/// a0, a1 - a0, a2 - a0 of n numbers -> their values at the pixel.
template <int n>
inline void interpolate(const Records& r, const Barycentrics& b, size_t member_offset, real (&to)[n]) {
    r.each<3 * n>(member_offset, [&](int p, const part::real(&a)[3 * n]) {
        const part::real b1 = part_of(b.b1, p), b2 = part_of(b.b2, p);
        for (int k = 0; k < n; ++k) part_of(to[k], p) = a[3 * k] + b1 * a[3 * k + 1] + b2 * a[3 * k + 2];
    });
}

inline vec3 interpolate3(const Records& r, const Barycentrics& b, size_t member_offset) {
    real v[3];
    interpolate(r, b, member_offset, v);
    return vec3(v[0], v[1], v[2]);
}

/// A vector, and the sign that follows it in the record.
inline SignedVector interpolate_signed(const Records& r, const Barycentrics& b, size_t member_offset) {
    SignedVector to;
    r.each<10>(member_offset, [&](int p, const part::real(&a)[10]) {
        const part::real b1 = part_of(b.b1, p), b2 = part_of(b.b2, p);
        part_of(to.v.x, p) = a[0] + b1 * a[1] + b2 * a[2];
        part_of(to.v.y, p) = a[3] + b1 * a[4] + b2 * a[5];
        part_of(to.v.z, p) = a[6] + b1 * a[7] + b2 * a[8];
        part_of(to.sign, p) = a[9];
    });
    return to;
}
/// With ShadeTriangle::facing and ::handedness.
inline SignedVector normal_at(const Records& r, const Barycentrics& b) {
    static_assert(offsetof(ShadeTriangle, facing) == offsetof(ShadeTriangle, normal) + 9 * sizeof(float));
    return interpolate_signed(r, b, offsetof(ShadeTriangle, normal));
}
inline SignedVector tangent_at(const Records& r, const Barycentrics& b) {
    static_assert(offsetof(ShadeTriangle, handedness) == offsetof(ShadeTriangle, tangent) + 9 * sizeof(float));
    return interpolate_signed(r, b, offsetof(ShadeTriangle, tangent));
}

inline vec4 interpolate_color(const Records& r, const Barycentrics& b) {
    real v[4];
    interpolate(r, b, offsetof(ShadeTriangle, color), v);
    return vec4(v[0], v[1], v[2], v[3]);
}

template <int set>
inline void find_texcoords_of(const Records& r, const Barycentrics& b, TexCoords& to) {
    static_assert(offsetof(ShadeTriangle, slope0) == offsetof(ShadeTriangle, texcoord0) + 6 * sizeof(float));
    static_assert(offsetof(ShadeTriangle, slope1) == offsetof(ShadeTriangle, texcoord1) + 6 * sizeof(float));
    constexpr size_t at = set == 0 ? offsetof(ShadeTriangle, texcoord0) : offsetof(ShadeTriangle, texcoord1);
    r.each<10>(at, [&](int p, const part::real(&a)[10]) {
        const part::real b1 = part_of(b.b1, p), b2 = part_of(b.b2, p), w = part_of(b.w, p);
        const part::real per_w_dx = part_of(b.per_w_dx, p), per_w_dy = part_of(b.per_w_dy, p);
        const part::real u = b1 * a[1] + b2 * a[2], v = b1 * a[4] + b2 * a[5];  // about corner 0
        part_of(to.uv.x, p) = a[0] + u;
        part_of(to.uv.y, p) = a[3] + v;
        part_of(to.dx.x, p) = (a[6] - u * per_w_dx) * w;
        part_of(to.dx.y, p) = (a[8] - v * per_w_dx) * w;
        part_of(to.dy.x, p) = (a[7] - u * per_w_dy) * w;
        part_of(to.dy.y, p) = (a[9] - v * per_w_dy) * w;
    });
}

inline void find_texcoords(const Records& r, const Barycentrics& b, int set, TexCoords& to) {
    set == 0 ? find_texcoords_of<0>(r, b, to) : find_texcoords_of<1>(r, b, to);
}

}  // namespace rakelight::raster::RL_ISA
