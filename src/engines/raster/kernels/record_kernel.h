// SPDX-License-Identifier: Apache-2.0
// The shading records of triangles, a vector of triangles of one draw at a time: planes of the barycentrics over the
// screen, attributes of the corners in world axes. Per instruction set.
#pragma once
#include "cpu_shading/kernels/corners.h"
#include "engines/raster/kernels/interpolate.h"

namespace rakelight::raster::RL_ISA {
using cpu_shading::RL_ISA::facing_of, cpu_shading::RL_ISA::load_corner, cpu_shading::RL_ISA::load_normals,
    cpu_shading::RL_ISA::load_tangents;
using rakelight::wide::RL_ISA::load_rows4_at;
using rakelight::wide::RL_ISA::store_columns4;

/// The three corners of `lanes` triangles, and where they lie on the screen.
struct Corners : cpu_shading::RL_ISA::Corners {
    integer x[3], y[3];  ///< [1/256 px] about the tile's first pixel center
    mask is_back;
    bool has_piece;

    Corners(const RecordJob& job, int32_t first) {
        const float* const* const rows = reinterpret_cast<const float* const*>(job.row + first);
        real v[4][4];
        for (int k = 0; k < 4; ++k) load_rows4_at(rows, 4 * k, v[k]);
        const integer flags = bits_of(v[3][2]);
        is_back = (flags & integer(1)) != integer(0);
        has_piece = any_lane((flags & integer(1 << 8)) != integer(0));
        const mask is_swapped = (flags & integer(1 << 16)) != integer(0);
        const integer origin_x((job.tile_x << subpixel_bits) + 128), origin_y((job.tile_y << subpixel_bits) + 128);
        for (int k = 0; k < 3; ++k) {
            const int other = k == 0 ? 0 : 3 - k;
            x[k] = select(is_swapped, bits_of(v[other][0]), bits_of(v[k][0])) - origin_x;
            y[k] = select(is_swapped, bits_of(v[other][1]), bits_of(v[k][1])) - origin_y;
        }
        find(job, bits_of(v[3][1]));
    }
};

/// What a record has in common with its neighbors in memory: written four floats at a time.
struct RecordWriter {
    float* out;
    template <int n>
    void put(size_t member_offset, const real* v) const {
        static_assert(n % 4 == 0);
        for (int k = 0; k < n; k += 4)
            store_columns4(out + member_offset / sizeof(float) + k, shade_triangle_floats, v + k);
    }
};

/// The affine barycentrics b1 and b2 as planes: change per pixel in x and y, value at the origin.
inline void affine_planes(const Corners& c, real (&b1)[3], real (&b2)[3]) {
    const real x0 = to_real(c.x[0]), y0 = to_real(c.y[0]);
    const real dx1 = to_real(c.x[1] - c.x[0]), dy1 = to_real(c.y[1] - c.y[0]);
    const real dx2 = to_real(c.x[2] - c.x[0]), dy2 = to_real(c.y[2] - c.y[0]);
    const real area = dx1 * dy2 - dy1 * dx2;
    const real inverse = reciprocal(select(area == real(0.0f), real(1.0f), area));
    const real subpixels(256.0f);
    b1[0] = dy2 * subpixels * inverse;
    b1[1] = -dx2 * subpixels * inverse;
    b1[2] = (y0 * dx2 - x0 * dy2) * inverse;
    b2[0] = -dy1 * subpixels * inverse;
    b2[1] = dx1 * subpixels * inverse;
    b2[2] = (x0 * dy1 - y0 * dx1) * inverse;
}

/// Changes per pixel of the record's b1 and b2.
struct Slopes {
    real b1[2], b2[2];
};

/// b1, b2 and depth of the record.
inline Slopes put_planes(const RecordJob& job, const Corners& c, const RecordWriter& to) {
    real v[12], b1[3], b2[3], key[3];
    affine_planes(c, b1, b2);
    for (int32_t k = 0; k < 3; ++k) {
        real clip[4];
        load_corner<4>(job.clip, c, k, clip);
        key[k] = job.orthographic != 0 ? clip[3] : reciprocal(clip[2]);
    }
    for (int i = 0; i < 3; ++i) {
        v[i] = job.affine != 0 ? b1[i] : b1[i] * key[1];
        v[3 + i] = job.affine != 0 ? b2[i] : b2[i] * key[2];
        v[6 + i] = b1[i] * (key[1] - key[0]) + b2[i] * (key[2] - key[0]);
    }
    v[8] = v[8] + key[0];
    v[9] = v[10] = v[11] = real(0.0f);  // texcoord0, written after
    to.put<12>(offsetof(ShadeTriangle, b1), v);
    return {{v[0], v[1]}, {v[3], v[4]}};
}

/// a0, a1 - a0, a2 - a0 of a vector attribute.
inline void set_deltas(const vec3 (&a)[3], real* v) {
    v[0] = a[0].x, v[1] = a[1].x - a[0].x, v[2] = a[2].x - a[0].x;
    v[3] = a[0].y, v[4] = a[1].y - a[0].y, v[5] = a[2].y - a[0].y;
    v[6] = a[0].z, v[7] = a[1].z - a[0].z, v[8] = a[2].z - a[0].z;
}

/// A set of texture coordinates and its slopes.
inline void put_texcoords(const float* base, const Corners& c, const Slopes& slopes, real* v) {
    real at[3][2];
    for (int32_t k = 0; k < 3; ++k) load_corner<2>(base, c, k, at[k]);
    for (int j = 0; j < 2; ++j) {
        const real to_1 = at[1][j] - at[0][j], to_2 = at[2][j] - at[0][j];
        v[3 * j] = at[0][j], v[3 * j + 1] = to_1, v[3 * j + 2] = to_2;
        for (int axis = 0; axis < 2; ++axis) v[6 + 2 * j + axis] = slopes.b1[axis] * to_1 + slopes.b2[axis] * to_2;
    }
}

/// Texture coordinates, normal, facing, tangent, handedness.
inline void put_surface(const RecordJob& job, const Corners& c, const Slopes& slopes, const RecordWriter& to) {
    real v[32];
    for (real& x : v) x = real(0.0f);
    if (job.texcoords[0] != nullptr) put_texcoords(job.texcoords[0], c, slopes, v);
    vec3 corner[3];
    load_normals(job, c, corner);
    set_deltas(corner, v + 10);
    v[19] = facing_of(job, c, c.is_back);
    v[29] = load_tangents(job, c, corner);
    set_deltas(corner, v + 20);
    to.put<32>(offsetof(ShadeTriangle, texcoord0), v);
}

/// The second set of texture coordinates and the vertex colors, which few meshes have.
inline void put_rest(const RecordJob& job, const Corners& c, const Slopes& slopes, const RecordWriter& to) {
    if (job.whole == 0) return;
    real v[24];
    for (real& x : v) x = real(0.0f);
    if (job.texcoords[1] != nullptr) put_texcoords(job.texcoords[1], c, slopes, v);
    if (job.colors == nullptr) {
        for (int j = 0; j < 4; ++j) v[10 + 3 * j] = real(1.0f);
    } else {
        real at[3][4];
        for (int32_t k = 0; k < 3; ++k) load_corner<4>(job.colors, c, k, at[k]);
        for (int j = 0; j < 4; ++j)
            v[10 + 3 * j] = at[0][j], v[11 + 3 * j] = at[1][j] - at[0][j], v[12 + 3 * j] = at[2][j] - at[0][j];
    }
    to.put<24>(offsetof(ShadeTriangle, texcoord1), v);
}

static int32_t record(const RecordJob* given) {
    const RecordJob& job = *given;
    bool has_piece = false;
    for (int32_t i = 0; i < job.count; i += lanes) {
        const Corners c(job, i);
        has_piece |= c.has_piece;
        const RecordWriter to{reinterpret_cast<float*>(job.out + i)};
        const Slopes slopes = put_planes(job, c, to);
        put_surface(job, c, slopes, to);
        put_rest(job, c, slopes, to);
    }
    return has_piece ? 1 : 0;
}

}  // namespace rakelight::raster::RL_ISA
