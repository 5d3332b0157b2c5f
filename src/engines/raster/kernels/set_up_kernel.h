// SPDX-License-Identifier: Apache-2.0
// Triangles: culled by side, area, window and pixel centers, a vector of them at a time. Per instruction set.
#pragma once
#include "engines/raster/kernels/clip_planes.h"
#include "engines/raster/kernels/geometry_types.h"
#include "math/wide_rows.h"

namespace rakelight::raster::RL_ISA {
RL_USE_WIDE;
using wide::RL_ISA::load_vectors;

inline uint32_t count_lanes(mask m) { return uint32_t(__builtin_popcount(lane_bits(m))); }

/// Corners in order of positive area, and the pixels whose centers may be inside.
struct TriangleVector {
    integer x[3], y[3];
    integer left, top, right, bottom;  ///< px in the picture, in the window
    mask is_swapped;
};

/// Whether the center of one of the four corner pixels of the box is inside: all there are in boxes of up to 2 x 2.
/// Edge functions with the top-left rule as in coverage.h.
inline mask hits_a_corner_pixel(const TriangleVector& t, mask is_tiny) {
    const integer zero(0), one(1), pixel(1 << subpixel_bits), half(1 << (subpixel_bits - 1));
    const integer px = (t.left << subpixel_bits) + half, py = (t.top << subpixel_bits) + half;
    const integer across = select(t.right > t.left, pixel, zero), down = select(t.bottom > t.top, pixel, zero);
    integer outside[4] = {zero, zero, zero, zero};
    for (int k = 0; k < 3; ++k) {
        const int n = k == 2 ? 0 : k + 1;
        const integer dx = select(is_tiny, t.x[n] - t.x[k], zero), dy = select(is_tiny, t.y[n] - t.y[k], zero);
        const integer from_x = select(is_tiny, px - t.x[k], zero), from_y = select(is_tiny, py - t.y[k], zero);
        const mask is_top_or_left = dy < zero || (dy == zero && dx > zero);
        const integer edge = dx * from_y - dy * from_x - select(is_top_or_left, zero, one);
        const integer right = edge - dy * across, step = dx * down;
        outside[0] = outside[0] | edge;
        outside[1] = outside[1] | right;
        outside[2] = outside[2] | (edge + step);
        outside[3] = outside[3] | (right + step);
    }
    return (outside[0] & outside[1] & outside[2] & outside[3]) >= zero;
}

inline void copy_vertex(TriangleRow& row, int corner, const ScreenVertex& v) {
    reinterpret_cast<ScreenVertex*>(&row)[corner] = v;
}

/// Corners in order of positive area, and the box of the pixels whose centers may be inside.
inline TriangleVector with_box(const SetUpJob& job, const integer (&x)[3], const integer (&y)[3], mask is_swapped) {
    TriangleVector t;
    t.is_swapped = is_swapped;
    t.x[0] = x[0], t.x[1] = select(is_swapped, x[2], x[1]), t.x[2] = select(is_swapped, x[1], x[2]);
    t.y[0] = y[0], t.y[1] = select(is_swapped, y[2], y[1]), t.y[2] = select(is_swapped, y[1], y[2]);
    const integer before(127 - job.reach), after(128 - job.reach);
    t.left = max((min(min(x[0], x[1]), x[2]) + before) >> subpixel_bits, integer(job.left));
    t.right = min((max(max(x[0], x[1]), x[2]) - after) >> subpixel_bits, integer(job.right));
    t.top = max((min(min(y[0], y[1]), y[2]) + before) >> subpixel_bits, integer(job.top));
    t.bottom = min((max(max(y[0], y[1]), y[2]) - after) >> subpixel_bits, integer(job.bottom));
    return t;
}

/// The tile and the row of each triangle in `is_kept`; `is_slow` ones are still to be cut. Returns how many there are.
inline int32_t write_rows(const SetUpJob& job, const uint32_t* indices, uint32_t first, const TriangleVector& t,
                          mask is_back, mask is_slow, mask is_kept, TriangleRow* rows, uint32_t* tiles) {
    const integer tile_x = t.left >> tile_bits, tile_y = t.top >> tile_bits;
    const mask is_in_one = tile_x == t.right >> tile_bits && tile_y == t.bottom >> tile_bits;
    const integer tile =
        (tile_y - integer(job.first_tile_y)) * integer(job.columns) + tile_x - integer(job.first_tile_x);
    int32_t tile_of[lanes];
    store(tile_of,
          select(is_slow, integer(int32_t(to_be_cut)), select(is_in_one, tile, integer(int32_t(in_many_tiles)))));
    const uint32_t back = lane_bits(is_back), swapped = lane_bits(t.is_swapped);
    int32_t written = 0;
    for (uint32_t left = lane_bits(is_kept); left != 0; left &= left - 1) {
        const int i = __builtin_ctz(left);
        const uint32_t swap = swapped >> i & 1u;
        const uint32_t* const corner = indices + 3 * i;
        TriangleRow& row = rows[written];
        copy_vertex(row, 0, job.vertices[corner[0]]);
        copy_vertex(row, 1, job.vertices[corner[1 + swap]]);
        copy_vertex(row, 2, job.vertices[corner[2 - swap]]);
        row.draw = job.draw;
        row.triangle = first + uint32_t(i);
        row.is_back = (back >> i & 1u) != 0, row.is_piece = false, row.is_swapped = swap != 0, row.is_large = false;
        tiles[written++] = uint32_t(tile_of[i]);
    }
    return written;
}

inline int32_t set_up_vector(SetUpJob& job, const uint32_t* indices, mask is_there, uint32_t first, TriangleRow* rows,
                             uint32_t* tiles) {
    const integer zero(0), everywhere = broadcast_i(int32_t(outside_all));
    // 1. Corners; who is wholly outside, and who is left to plain functions.
    integer x[3], y[3], code[3];
    for (int k = 0; k < 3; ++k) {
        real v[4];
        load_vectors<4, 3>(reinterpret_cast<const float*>(job.vertices), indices + k, v);
        x[k] = bits_of(v[0]), y[k] = bits_of(v[1]), code[k] = bits_of(v[3]) & everywhere;
    }
    const integer any = code[0] | code[1] | code[2], all = code[0] & code[1] & code[2];
    const mask is_outside =
        is_there && (all != zero || code[0] == everywhere || code[1] == everywhere || code[2] == everywhere);
    const mask is_rest = is_there && !is_outside;
    const integer low_x = min(min(x[0], x[1]), x[2]), high_x = max(max(x[0], x[1]), x[2]);
    const integer low_y = min(min(y[0], y[1]), y[2]), high_y = max(max(y[0], y[1]), y[2]);
    const integer limit(small_extent);
    const mask is_small = high_x - low_x < limit && high_y - low_y < limit;
    const mask is_slow = is_rest && ((any & integer(int32_t(cutting_planes))) != zero || !is_small);
    mask passes = is_rest && !is_slow;

    // 2. Area and side.
    const integer dx1 = select(passes, x[1] - x[0], zero), dy1 = select(passes, y[1] - y[0], zero);
    const integer dx2 = select(passes, x[2] - x[0], zero), dy2 = select(passes, y[2] - y[0], zero);
    const integer area = dx1 * dy2 - dx2 * dy1;
    const mask is_flat = passes && area == zero;
    const mask is_back = job.front_is_negative != 0 ? area > zero : area < zero;
    const mask is_culled =
        passes && !is_flat && ((is_back && mask(job.cull_back != 0)) || (!is_back && mask(job.cull_front != 0)));
    passes = passes && !is_flat && !is_culled;
    job.culled_outside += count_lanes(is_outside);
    job.culled_degenerate += count_lanes(is_flat);
    job.culled_back += count_lanes(is_culled);
    const bool looks_at_culled = job.hides_in_window == 0 && any_lane(is_culled);
    if (no_lane(passes || is_slow) && !looks_at_culled) return 0;

    // 3. The pixel centers of the box, and of small boxes those inside.
    const TriangleVector t = with_box(job, x, y, area < zero);
    const mask has_centers = t.left <= t.right && t.top <= t.bottom;
    if (looks_at_culled) job.hides_in_window = any_lane(is_culled && has_centers);
    const integer one(1);
    const mask is_tiny = passes && has_centers && t.right - t.left <= one && t.bottom - t.top <= one;
    mask is_hit = has_centers;
    if (job.reach == 0 && any_lane(is_tiny)) is_hit = is_hit && (!is_tiny || hits_a_corner_pixel(t, is_tiny));
    const mask is_missed = passes && !is_hit;
    passes = passes && is_hit;

    job.culled_outside += count_lanes(is_missed);

    // 4. The tile, and the rows of those that are left.
    return write_rows(job, indices, first, t, is_back, is_slow, passes || is_slow, rows, tiles);
}

static int32_t set_up(SetUpJob* given) {
    SetUpJob job = *given;
    int32_t written = 0, i = 0;
    for (; i + lanes <= job.count; i += lanes)
        written += set_up_vector(job, job.indices + 3 * i, mask(true), job.first + uint32_t(i), job.rows + written,
                                 job.tiles + written);
    if (i < job.count) {
        uint32_t rest[3 * lanes];  // the last triangle again and again
        for (int32_t k = 0; k < 3 * lanes; ++k)
            rest[k] = job.indices[3 * (i + (k / 3 < job.count - i ? k / 3 : job.count - 1 - i)) + k % 3];
        const mask is_there = lane_indices() < integer(job.count - i);
        written += set_up_vector(job, rest, is_there, job.first + uint32_t(i), job.rows + written, job.tiles + written);
    }
    given->culled_back = job.culled_back;
    given->culled_degenerate = job.culled_degenerate;
    given->culled_outside = job.culled_outside;
    given->hides_in_window = job.hides_in_window;
    return written;
}

}  // namespace rakelight::raster::RL_ISA
