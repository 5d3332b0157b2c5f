// SPDX-License-Identifier: Apache-2.0
// Coverage and depth test of small triangles in one tile: set up a vector of triangles at a time, then drawn one by
// one, a block of pixels at a time. Per instruction set.
#pragma once
#include "engines/raster/kernels/geometry_types.h"
#include "math/wide_blocks.h"
#include "math/wide_double.h"
#include "math/wide_rows.h"

namespace rakelight::raster::RL_ISA {
RL_USE_WIDE;
using wide::RL_ISA::block_height;
using wide::RL_ISA::block_width;
using wide::RL_ISA::block_x;
using wide::RL_ISA::block_y;
using wide::RL_ISA::load_block;
using wide::RL_ISA::load_rows4_at;
using wide::RL_ISA::real_double;
using wide::RL_ISA::store_block;
using wide::RL_ISA::to_double;

/// Blocks of a grid, one per lane: 4 x 4, 2 x 4, 2 x 2 or one.
inline constexpr int grid_column_bits = lanes == 16 ? 2 : lanes >= 4 ? 1 : 0;
inline constexpr int grid_columns = 1 << grid_column_bits, grid_rows = lanes / grid_columns;

/// What drawing a triangle needs, one number a lane. The same numbers as set_coverage() (coverage.h); edge functions in
/// float, which holds them exactly: they are whole and below 2^24.
struct CoverageVector {
    int32_t left[lanes], top[lanes], right[lanes], bottom[lanes];  ///< px in the tile
    float edge[3][lanes], step_x[3][lanes], step_y[3][lanes];      ///< at (left, top)
    float reach[3][lanes];  ///< the most that a block at (left, top) sees of `edge`
    float depth_0[lanes], depth_x[lanes], depth_y[lanes], low[lanes], high[lanes];
};

/// Corners relative to a tile: rounded places, what rounding cut off, depth keys.
struct TileCorners {
    integer x[3], y[3], fine_x[3], fine_y[3];
    real key[3];
};

inline TileCorners load_corners(const NearestJob& job, const TriangleRow* const* rows) {
    TileCorners c;
    const integer origin_x((job.tile_x << subpixel_bits) + job.sample_x),
        origin_y((job.tile_y << subpixel_bits) + job.sample_y);
    for (int k = 0; k < 3; ++k) {
        real v[4];
        load_rows4_at(reinterpret_cast<const float* const*>(rows), 4 * k, v);
        c.x[k] = bits_of(v[0]) - origin_x, c.y[k] = bits_of(v[1]) - origin_y, c.key[k] = v[2];
        c.fine_x[k] = (bits_of(v[3]) >> outcode_bits) & integer((1 << fine_bits) - 1);
        c.fine_y[k] = shift_right_logical(bits_of(v[3]), outcode_bits + fine_bits);
    }
    return c;
}

/// @return the triangles that may be nearer than the surfaces so far somewhere
inline mask set_coverage_vector(const NearestJob& job, const TriangleRow* const* rows, CoverageVector& c) {
    // 1. Corners relative to the tile, and the box.
    const TileCorners corners = load_corners(job, rows);
    const auto& [x, y, fine_x, fine_y, key] = corners;
    const real high = max(max(key[0], key[1]), key[2]), low = min(min(key[0], key[1]), key[2]);
    const integer zero(0), one(1), last(tile_size - 1), before(127), after(128);
    const integer left = max((min(min(x[0], x[1]), x[2]) + before) >> subpixel_bits, zero);
    const integer right = min((max(max(x[0], x[1]), x[2]) - after) >> subpixel_bits, last);
    const integer top = max((min(min(y[0], y[1]), y[2]) + before) >> subpixel_bits, zero);
    const integer bottom = min((max(max(y[0], y[1]), y[2]) - after) >> subpixel_bits, last);
    const mask is_seen = high > real(job.farthest) && max(left, integer(job.left)) <= min(right, integer(job.right)) &&
                         max(top, integer(job.top)) <= min(bottom, integer(job.bottom));
    if (no_lane(is_seen)) return is_seen;
    // 2. Edge functions with the top-left rule.
    const integer px = (left << subpixel_bits) + after, py = (top << subpixel_bits) + after;
    integer dx[3], dy[3];
    for (int k = 0; k < 3; ++k) {
        const int n = k == 2 ? 0 : k + 1;
        dx[k] = x[n] - x[k], dy[k] = y[n] - y[k];
        const mask is_top_or_left = dy[k] < zero || (dy[k] == zero && dx[k] > zero);
        const integer from_x = select(is_seen, px - x[k], zero), from_y = select(is_seen, py - y[k], zero);
        const integer edge = (dx[k] * from_y - dy[k] * from_x - select(is_top_or_left, zero, one)) >> subpixel_bits;
        store(c.edge[k], to_real(edge));
        store(c.reach[k], to_real(edge + max(zero - dy[k], zero) * integer(block_width - 1) +
                                  max(dx[k], zero) * integer(block_height - 1)));
        store(c.step_x[k], to_real(zero - dy[k]));
        store(c.step_y[k], to_real(dx[k]));
    }
    // 3. The plane of the keys through the true corners, in double: its numerators are exact, whatever the order of the
    // corners.
    const real_double x1 = to_double((dx[0] << fine_bits) + fine_x[1] - fine_x[0]),
                      y1 = to_double((dy[0] << fine_bits) + fine_y[1] - fine_y[0]);
    const real_double x2 = to_double(fine_x[2] - fine_x[0] - (dx[2] << fine_bits)),
                      y2 = to_double(fine_y[2] - fine_y[0] - (dy[2] << fine_bits));
    const real_double key_0 = to_double(key[0]), key_1 = to_double(key[1]) - key_0, key_2 = to_double(key[2]) - key_0;
    const real_double per_area = real_double(1.0) / (x1 * y2 - x2 * y1);
    const real_double slope_x = (key_1 * y2 - key_2 * y1) * per_area, slope_y = (key_2 * x1 - key_1 * x2) * per_area;
    const integer middle(1 << (fine_bits - 1));
    const real_double from_x = to_double((select(is_seen, px - x[0], zero) << fine_bits) + middle - fine_x[0]);
    const real_double from_y = to_double((select(is_seen, py - y[0], zero) << fine_bits) + middle - fine_y[0]);
    store(c.depth_0, to_real(key_0 + slope_x * from_x + slope_y * from_y));
    const real_double pixel(double(1 << (subpixel_bits + fine_bits)));
    store(c.depth_x, to_real(slope_x * pixel));
    store(c.depth_y, to_real(slope_y * pixel));
    store(c.low, low);
    store(c.high, high);
    store(c.left, left);
    store(c.top, top);
    store(c.right, right);
    store(c.bottom, bottom);
    return is_seen;
}

/// One block of pixels of triangle i, which begins at (x, y) of the tile. Returns how many were written.
template <bool is_whole>
inline uint32_t draw_block(const NearestJob& job, const CoverageVector& c, int i, int32_t x, int32_t y,
                           int32_t position) {
    const integer from_x = block_x() + integer(x - c.left[i]), from_y = block_y() + integer(y - c.top[i]);
    const real fx = to_real(from_x), fy = to_real(from_y);
    integer outside(0);
    for (int k = 0; k < 3; ++k)
        outside = outside | bits_of(real(c.edge[k][i]) + real(c.step_y[k][i]) * fy + real(c.step_x[k][i]) * fx);
    mask covered = outside >= integer(0);
    if constexpr (!is_whole) {
        const integer at_x = block_x() + integer(x), at_y = block_y() + integer(y);
        covered = covered && at_x >= integer(job.left) && at_x <= integer(job.right) && at_y >= integer(job.top) &&
                  at_y <= integer(job.bottom);
    }
    const real plane = (real(c.depth_0[i]) + real(c.depth_y[i]) * fy) + real(c.depth_x[i]) * fx;
    const real depth = min(max(plane, real(c.low[i])), real(c.high[i]));
    const int32_t at = y * tile_size + x;
    const mask nearer = covered && depth > load_block(job.depth + at, tile_size);  // the first of equals stays
    if constexpr (lanes < 8)  // a store of nothing is cheaper than a branch that is often guessed wrong
        if (no_lane(nearer)) return 0;
    store_block(job.depth + at, tile_size, depth, nearer);
    store_block(job.visible + at, tile_size, integer(position), nearer);
    return uint32_t(__builtin_popcount(lane_bits(nearer)));
}

/// Which blocks of a grid over the triangle's box, one per lane, may have covered pixels; the grid begins at (x, y).
inline uint32_t blocks_in_reach(const CoverageVector& c, int i, int32_t x, int32_t y) {
    const integer to_right =
        (lane_indices() & integer(grid_columns - 1)) * integer(block_width) + integer(x - c.left[i]);
    const integer down =
        shift_right_logical(lane_indices(), grid_column_bits) * integer(block_height) + integer(y - c.top[i]);
    const real fx = to_real(to_right), fy = to_real(down);
    mask reached = to_right <= integer(c.right[i] - c.left[i]) && down <= integer(c.bottom[i] - c.top[i]);
    for (int k = 0; k < 3; ++k) {
        const real most = real(c.reach[k][i]) + real(c.step_y[k][i]) * fy + real(c.step_x[k][i]) * fx;
        reached = reached && most >= real(0.0f);
    }
    return lane_bits(reached);
}

template <bool is_whole>
inline uint32_t draw_triangle(const NearestJob& job, const CoverageVector& c, int i, int32_t position) {
    constexpr int32_t last_x = tile_size - block_width, last_y = tile_size - block_height;  // blocks stay in the tile
    const auto draw = [&](int32_t x, int32_t y) {
        return draw_block<is_whole>(job, c, i, x < last_x ? x : last_x, y < last_y ? y : last_y, position);
    };
    const int32_t left = c.left[i], top = c.top[i], right = c.right[i], bottom = c.bottom[i];
    uint32_t written = 0;
    if (right - left < 2 * block_width && bottom - top < 2 * block_height) {  // few: not worth a look
        for (int32_t y = top; y <= bottom; y += block_height)
            for (int32_t x = left; x <= right; x += block_width) written += draw(x, y);
        return written;
    }
    for (int32_t y = top; y <= bottom; y += grid_rows * block_height)
        for (int32_t x = left; x <= right; x += grid_columns * block_width)
            for (uint32_t blocks = blocks_in_reach(c, i, x, y); blocks != 0; blocks &= blocks - 1) {
                const int32_t b = __builtin_ctz(blocks);
                written += draw(x + (b & (grid_columns - 1)) * block_width, y + (b >> grid_column_bits) * block_height);
            }
    return written;
}

template <bool is_whole>
inline int32_t draw_all(const NearestJob& job) {
    CoverageVector c{};
    uint32_t written = 0;
    for (int32_t first = 0; first < job.count; first += lanes) {
        const TriangleRow* const* rows = job.rows + first;
        const TriangleRow* rest[lanes];
        if (first + lanes > job.count) {
            for (int32_t i = 0; i < lanes; ++i) rest[i] = rows[i < job.count - first ? i : job.count - 1 - first];
            rows = rest;
        }
        const mask is_there = lane_indices() < integer(job.count - first);
        for (int32_t i = first + lanes; i < first + 2 * lanes && i < job.total; ++i) __builtin_prefetch(job.rows[i]);
        for (uint32_t left = lane_bits(is_there && set_coverage_vector(job, rows, c)); left != 0; left &= left - 1) {
            const int i = __builtin_ctz(left);
            written += draw_triangle<is_whole>(job, c, i, job.position + first + i);
        }
    }
    return int32_t(written);
}

static int32_t nearest(const NearestJob* given) {
    const NearestJob job = *given;
    const bool is_whole = job.left == 0 && job.top == 0 && job.right == tile_size - 1 && job.bottom == tile_size - 1;
    return is_whole ? draw_all<true>(job) : draw_all<false>(job);
}

}  // namespace rakelight::raster::RL_ISA
