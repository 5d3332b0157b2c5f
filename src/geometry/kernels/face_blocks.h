// SPDX-License-Identifier: Apache-2.0
// The loop over the faces of a mesh, for kernels that add a row to each of their corners' vertices. A block of faces is
// staged as structures of arrays, computed `lanes` at a time, turned into rows and added corner by corner, in the order of
// the faces: bit-identical in every flavor.
#pragma once
#include "geometry/fast/fast_kernel_types.h"
#include "math/wide_rows.h"

namespace rakelight::geometry::RL_ISA {
RL_USE_WIDE;
using rakelight::wide::RL_ISA::load_vectors, rakelight::wide::RL_ISA::store_rows4, rakelight::wide::RL_ISA::store_rows8;

typedef float Row4 __attribute__((vector_size(16), aligned(4), may_alias));
typedef float Row8 __attribute__((vector_size(32), aligned(4), may_alias));
template <int floats>
struct RowOf;
template <>
struct RowOf<4> {
    using type = Row4;
};
template <>
struct RowOf<8> {
    using type = Row8;
};

// Float is safe where sums of squares neither overflow nor come near the denormals, and where the edges are not nearly
// parallel. An angle between 0.9 and 179.1 degrees loses at most six bits of the cross product.
static inline mask is_safe(real cross_square, real square1, real square2) {
    return cross_square >= square1 * square2 * real(1.0f / 4096) && cross_square > real(1e-34f) &&
           cross_square < real(1e34f);
}

/// A vector across n, far from zero.
static inline vec3 across(const vec3& n) {
    const mask upright = abs(n.z) > real(0.6f);
    const real zero(0.0f);
    return {select(upright, zero, -n.y), select(upright, -n.z, n.x), select(upright, n.y, zero)};
}

/// The vertices of a block, by its indices.
struct BlockSource {
    const float* positions;
    const float* texcoords;  ///< or null
    const float* normals;    ///< or null
    const uint32_t* index;   ///< [3 * face_block]
};
static inline vec3 corner_vector(const float* vectors, const uint32_t* corner) {
    real v[3];
    load_vectors<3, 3>(vectors, corner, v);
    return vec3(v[0], v[1], v[2]);
}

// Vectors are loaded as four floats, so incomplete blocks, and blocks that use the last vertex of the mesh, read from a
// copy.
struct BlockCopy {
    float position[3 * 3 * face_block + 4], texcoord[2 * 3 * face_block + 4], normal[3 * 3 * face_block + 4];
    uint32_t index[3 * face_block];
};
static inline BlockSource copy_block(const ScatterJob& job, const uint32_t* index, uint32_t count, BlockCopy& copy) {
    for (uint32_t i = 0; i < 3 * face_block; ++i) {
        const uint64_t v = index[i < 3 * count ? i : 0];
        copy.index[i] = i;
        for (uint32_t a = 0; a < 3; ++a) copy.position[3 * i + a] = job.positions[3 * v + a];
        if (job.texcoords)
            for (uint32_t a = 0; a < 2; ++a) copy.texcoord[2 * i + a] = job.texcoords[2 * v + a];
        if (job.normals)
            for (uint32_t a = 0; a < 3; ++a) copy.normal[3 * i + a] = job.normals[3 * v + a];
    }
    return {copy.position, copy.texcoord, copy.normal, copy.index};
}

/// Rows of a block's faces, those of all first corners before those of the second ones; or one for all corners.
template <int floats, bool alike>
struct BlockRows {
    alignas(64) float numbers[(alike ? 1 : 3) * face_block * floats];
    float* of(uint32_t face, uint32_t corner) {
        return numbers + uint32_t(floats) * ((alike ? 0 : corner * face_block) + face);
    }
    void put(uint32_t face, uint32_t corner, const real* v) {
        if constexpr (floats == 8)
            store_rows8(of(face, corner), v);
        else
            store_rows4(of(face, corner), v);
    }
};

// Common case: only vertices of the own piece, and no unsafe face.
template <int floats, bool alike>
static inline void add_own_block(float* own, const uint32_t* index, BlockRows<floats, alike>& rows) {
    using Row = typename RowOf<floats>::type;
    for (uint32_t f = 0; f < face_block; ++f)
        for (uint32_t k = 0; k < 3; ++k) {
            Row* to = reinterpret_cast<Row*>(own + uint64_t(floats) * index[3 * f + k]);
            *to = *to + *reinterpret_cast<const Row*>(rows.of(f, k));
        }
}

template <int floats, bool alike>
static inline void add_block(ScatterJob& job, const uint32_t* index, uint32_t count, uint32_t odd,
                             BlockRows<floats, alike>& rows) {
    using Row = typename RowOf<floats>::type;
    FastParcel<floats>* parcels = static_cast<FastParcel<floats>*>(job.foreign);
    const uint32_t own_begin = job.own_begin, own_size = job.own_end - own_begin;
    for (uint32_t f = 0; f < count; ++f) {
        if ((odd >> f & 1) != 0) {
            job.odd[job.odd_count++] = job.face + f;
            continue;
        }
        for (uint32_t k = 0; k < 3; ++k) {
            const Row row = *reinterpret_cast<const Row*>(rows.of(f, k));
            const uint32_t v = index[3 * f + k];
            if (v - own_begin < own_size) {
                Row* to = reinterpret_cast<Row*>(job.rows + uint64_t(floats) * v);
                *to = *to + row;
            } else {
                FastParcel<floats>& parcel = parcels[job.foreign_count++];
                parcel.vertex = v;
                *reinterpret_cast<Row*>(parcel.row) = row;
            }
        }
    }
}

/// Notes the indices of a block in the job. False: one is out of range, or rows are not ready.
static inline bool meet(ScatterJob& job, const uint32_t* index, uint32_t count, uint32_t& smallest, uint32_t& largest) {
    largest = 0, smallest = 0xffffffffu;
    if (count == face_block) {
        for (uint32_t i = 0; i < 3 * face_block; ++i) {
            largest = index[i] > largest ? index[i] : largest;
            smallest = index[i] < smallest ? index[i] : smallest;
        }
    } else {
        for (uint32_t i = 0; i < 3 * count; ++i) largest = index[i] > largest ? index[i] : largest;
        for (uint32_t i = 0; i < 3 * count; ++i) smallest = index[i] < smallest ? index[i] : smallest;
    }
    job.largest = largest > job.largest ? largest : job.largest;
    job.smallest = smallest < job.smallest ? smallest : job.smallest;
    if (largest >= job.vertices) {
        job.is_index_bad = true;
        return false;
    }
    job.wanted_end = largest < job.own_end ? largest + 1 : job.own_end;
    return job.wanted_end <= job.ready_end;
}

template <int floats, bool alike, class FaceRows>
static inline bool scatter_block(ScatterJob& job, const FaceRows& face_rows) {
    const uint32_t count = job.face_end - job.face < face_block ? job.face_end - job.face : face_block;
    const uint32_t* index = job.indices + 3 * uint64_t(job.face);
    uint32_t smallest, largest;
    if (!meet(job, index, count, smallest, largest)) return false;
    BlockRows<floats, alike> rows;
    uint32_t odd;
    if (count == face_block && largest + 1 < job.vertices) {
        odd = face_rows(BlockSource{job.positions, job.texcoords, job.normals, index}, rows);
    } else {
        BlockCopy copy;
        odd = face_rows(copy_block(job, index, count, copy), rows);
    }
    if (odd == 0 && count == face_block && smallest >= job.own_begin && largest < job.own_end)
        add_own_block(job.rows, index, rows);
    else
        add_block(job, index, count, odd, rows);
    job.face += count;
    return true;
}

/// @param face_rows  (source, rows) -> a bit for each face that is left to the caller
/// @tparam alike     all corners of a face get one row
template <int floats, bool alike, class FaceRows>
static inline void scatter_faces(ScatterJob* given, const FaceRows& face_rows) {
    ScatterJob job = *given;  // on this thread's own stack
    while (job.face < job.face_end && job.foreign_count + 3 * face_block <= parcel_capacity &&
           job.odd_count + face_block <= odd_capacity && scatter_block<floats, alike>(job, face_rows)) {
    }
    *given = job;
}

}  // namespace rakelight::geometry::RL_ISA
