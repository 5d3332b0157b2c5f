// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion of a rectangle of pixels, and its mean over neighbors: lighting/occlusion/horizons.glsl. Per instruction set.
#pragma once
#include "engines/raster/kernels/geometry_types.h"
#include "engines/raster/kernels/occlusion_types.h"
#include "math/wide.h"

namespace rakelight::raster::RL_ISA {
namespace occluded {

#include "math/prelude.h"

/// The keys that the pixels of a vector look at, and the directions of theirs.
struct Maps {
    const OcclusionJob& job;
    integer place;  ///< 0..15 in the square of pixels
};

inline real fetch_key(const Maps& maps, real column, real row) {
    const OcclusionJob& job = maps.job;
    const real low_x(float(job.left - 1)), high_x(float(job.right + 1)), low_y(float(job.top - 1));
    const integer x = to_int(clamp(column, low_x, high_x)) - integer(job.left);
    const integer y = to_int(clamp(row, low_y, real(float(job.bottom + 1)))) - integer(job.top);
    return gather(job.keys, y * integer(int32_t(job.key_stride)) + x);
}

inline vec2 slice_turn(const Maps& maps, int slice) {
    constexpr int places = occlusion_pattern * occlusion_pattern;
    return vec2(gather(maps.job.cosines + slice * places, maps.place),
                gather(maps.job.sines + slice * places, maps.place));
}

// clang-format off
#include "lighting/occlusion/horizons.glsl"
// clang-format on

inline OcclusionFactors factors_of(const OcclusionJob& job) {
    OcclusionFactors f;
    f.is_parallel = job.is_parallel, f.slices = job.slices, f.steps = job.steps;
    f.per_steps = real(1.0f / float(job.steps));
    f.ray_x = real(job.ray_x), f.ray_y = real(job.ray_y), f.first_x = real(job.first_x), f.first_y = real(job.first_y);
    f.near = real(job.near), f.depth_range = real(job.depth_range);
    f.radius = real(job.radius), f.most_pixels = real(job.most_pixels);
    return f;
}

/// A vector of pixels of one row.
struct Row {
    const OcclusionJob& job;
    integer x;
    real column, row, key;  ///< of lanes where nothing is: 1
    mask is_there;
    const float* keys;  ///< of the first pixel

    Row(const OcclusionJob& of, int32_t x0, int32_t y)
        : job(of),
          x(lane_indices() + integer(x0)),
          column(to_real(x)),
          row(float(y)),
          keys(of.keys + (y - of.top) * of.key_stride + (x0 - of.left)) {
        const real found = key_at(0, 0);
        is_there = found >= real(0.0f);
        key = select(is_there, found, real(1.0f));
    }
    real key_at(int dx, int dy) const { return load(keys + dy * job.key_stride + dx); }
    vec2 slope() const {
        return vec2(key_slope(key, key_at(-1, 0), key_at(-2, 0), key_at(1, 0), key_at(2, 0)),
                    key_slope(key, key_at(0, -1), key_at(0, -2), key_at(0, 1), key_at(0, 2)));
    }
};

/// Pixels at the rim count half, so that each place of the square of directions has the same part.
inline real mean_around(const OcclusionJob& job, const OcclusionFactors& f, const Row& at, const float* raw) {
    const vec2 slope = at.slope();
    const OcclusionPoint p = occlusion_point(f, at.column, at.row, at.key, slope);
    const real zero(0.0f);
    real sum = zero, weights = zero;
    for (int dy = -smoothing_reach; dy <= smoothing_reach; ++dy)
        for (int dx = -smoothing_reach; dx <= smoothing_reach; ++dx) {
            const bool is_rim_x = dx * dx == smoothing_reach * smoothing_reach;
            const bool is_rim_y = dy * dy == smoothing_reach * smoothing_reach;
            const real part((is_rim_x ? 0.5f : 1.0f) * (is_rim_y ? 0.5f : 1.0f));
            const vec2 change = vec2(real(float(dx)), real(float(dy)));
            const real weight = smoothing_weight(f, p, at.key, at.key_at(dx, dy), change, slope) * part;
            sum = sum + load(raw + dy * job.raw_stride + dx) * weight;
            weights = weights + weight;
        }
    return sum / max(weights, real(1e-20f));
}

}  // namespace occluded

/// Calls find(row, first pixel's index in its row) for each vector in which something is; others are 1.
template <class Find>
static inline void for_occlusion_rows(const OcclusionJob& job, const Find& find) {
    const real one(1.0f);
    for (int32_t y = job.y; y < job.y + job.height; ++y)
        for (int32_t x0 = job.x; x0 < job.x + job.width; x0 += lanes) {
            const occluded::Row row(job, x0, y);
            float* const to = job.openness + (y - job.y) * job.openness_stride + (x0 - job.x);
            store(to, no_lane(row.is_there) ? one : select(row.is_there, find(row, y, x0), one));
        }
}

static void occlusion(const OcclusionJob* given) {
    const OcclusionJob job = *given;
    const occluded::OcclusionFactors f = occluded::factors_of(job);
    for_occlusion_rows(job, [&](const occluded::Row& at, int32_t y, int32_t) {
        const integer in_square = (((at.x + integer(y)) & integer(3)) << 2) + (at.x & integer(3));
        const real offset = (to_real((integer(y) - at.x) & integer(3)) + real(0.5f)) * real(0.25f);
        const occluded::OcclusionPoint p = occluded::occlusion_point(f, at.column, at.row, at.key, at.slope());
        return occluded::ambient_openness(occluded::Maps{job, in_square}, f, p, at.column, at.row, offset);
    });
}

static void smooth_occlusion(const OcclusionJob* given) {
    const OcclusionJob job = *given;
    const occluded::OcclusionFactors f = occluded::factors_of(job);
    for_occlusion_rows(job, [&](const occluded::Row& at, int32_t y, int32_t x0) {
        return occluded::mean_around(job, f, at, job.raw + (y - job.y) * job.raw_stride + (x0 - job.x));
    });
}

}  // namespace rakelight::raster::RL_ISA
