// SPDX-License-Identifier: Apache-2.0
// The shading records of triangles, a vector of triangles of one draw at a time: planes of the barycentrics over the
// screen, attributes of the corners in world axes. Per instruction set.
#pragma once
#include "engines/raster/kernels/interpolate.h"
#include "math/wide_rows.h"

namespace rakelight::raster::RL_ISA {
using rakelight::wide::RL_ISA::load_rows4_at;
using rakelight::wide::RL_ISA::load_vectors;
using rakelight::wide::RL_ISA::store_columns4;

/// The three corners of `lanes` triangles, in the order of the mesh.
struct Corners {
    int32_t index[3][lanes];
    integer triangle;
    integer x[3], y[3];  ///< [1/256 px] about the tile's first pixel center
    mask is_back;
    bool has_piece;
    bool has_last;  ///< the last vertex is among them: what follows it in memory is not ours

    Corners(const RecordJob& job, int32_t first) {
        const float* const* const rows = reinterpret_cast<const float* const*>(job.row + first);
        real v[4][4];
        for (int k = 0; k < 4; ++k) load_rows4_at(rows, 4 * k, v[k]);
        triangle = bits_of(v[3][1]);
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
        mask is_last = mask(false);
        for (int32_t k = 0; k < 3; ++k) {
            const integer i = gather_i(job.indices, triangle * integer(3) + integer(k));
            store(index[k], i);
            is_last = is_last || i == integer(job.vertices - 1);
        }
        has_last = any_lane(is_last);
    }
};

/// `width` floats of each lane's vertex at corner k.
template <int width>
inline void load_corner(const float* base, const Corners& c, int32_t k, real* v) {
    if (!c.has_last || width == 4)
        return load_vectors<width, 1>(base, reinterpret_cast<const uint32_t*>(c.index[k]), v);
    for (int32_t j = 0; j < width; ++j) v[j] = gather(base + j, load_i(c.index[k]) * integer(width));
}

inline vec3 load_corner3(const float* base, const Corners& c, int32_t k) {
    real v[3];
    load_corner<3>(base, c, k, v);
    return vec3(v[0], v[1], v[2]);
}

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

inline vec3 transformed(const float (&rows)[3][3], vec3 v) {
    const auto row = [&](int r) { return real(rows[r][0]) * v.x + real(rows[r][1]) * v.y + real(rows[r][2]) * v.z; };
    return vec3(row(0), row(1), row(2));
}

/// Normal of the face in world axes, not unit.
inline vec3 face_normal(const RecordJob& job, const Corners& c) {
    const vec3 p0 = load_corner3(job.positions, c, 0);
    return transformed(job.to_normal,
                       cross(load_corner3(job.positions, c, 1) - p0, load_corner3(job.positions, c, 2) - p0));
}

/// -1 where the shading normal is to be turned round (lit_side.h).
inline real facing_of(const RecordJob& job, const Corners& c) {
    integer turns = select(c.is_back, integer(1), integer(0)) + integer(job.turned);
    if (job.against != nullptr) turns = turns + gather_i(job.against, c.triangle);
    return select((turns & integer(1)) != integer(0), real(-1.0f), real(1.0f));
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
    vec3 normal[3], tangent[3];
    if (job.normals == nullptr) normal[0] = normal[1] = normal[2] = safe_normalize(face_normal(job, c));
    for (int32_t k = 0; k < 3 && job.normals != nullptr; ++k)
        normal[k] = safe_normalize(transformed(job.to_normal, load_corner3(job.normals, c, k)));
    set_deltas(normal, v + 10);
    v[19] = facing_of(job, c);
    v[29] = real(job.mirror);
    for (int32_t k = 0; k < 3 && job.tangents != nullptr; ++k) {
        real t[4];
        load_corner<4>(job.tangents, c, k, t);
        tangent[k] = safe_normalize_or(transformed(job.linear, vec3(t[0], t[1], t[2])), vec3(real(0.0f)));
        if (k == 0) v[29] = v[29] * t[3];
    }
    if (job.tangents != nullptr) set_deltas(tangent, v + 20);
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
