// SPDX-License-Identifier: Apache-2.0
// The denoiser's sums (image/denoise.h has the equations). All pixels of a tile are compared with their neighbor at one
// offset, then at the next, so that patches share the distances of single pixels. The order of each lane's sums is
// independent of tile and lane counts.
#include "image/denoise_tile.h"
#include "math/wide.h"

namespace rakelight::denoise::RL_ISA {
RL_USE_WIDE;

static_assert(lanes <= max_lanes && tile_width % lanes == 0);

static inline int at(int x, int y) { return (y + margin) * stride + x + margin; }
static inline real square(real x) { return x * x; }

/// d of one pair of pixels, the sum of the channels.
static inline real pixel_distance(const Tile& t, int p, int q) {
    constexpr float k2 = 0.6f * 0.6f, least = 1e-30f;  // `least` keeps 0 / 0 away
    real sum = 0.0f;
    for (int c = 0; c < 3; ++c) {
        const real v_p = load(t.smooth_variance[c] + p), v_q = load(t.smooth_variance[c] + q);
        const real difference = load(t.light[c] + p) - load(t.light[c] + q);
        sum += (square(difference) - (v_p + min(v_p, v_q))) / ((v_p + v_q) * real(k2) + real(least));
    }
    // Clamped, because infinity times 0 would be NaN; 1e4 / 75 gives a weight of 0 anyway.
    return min(sum, real(1e4f)) * (load(t.valid + p) * load(t.valid + q));
}

/// F
static inline real feature_distance(const Tile& t, int p, int q) {
    constexpr float plane_bandwidth2 = 0.15f * 0.15f, least = 1e-30f;
    real normals = 0.0f, albedos = 0.0f, from_p = 0.0f, from_q = 0.0f, length2 = 0.0f;
    for (int c = 0; c < 3; ++c) {
        const real n_p = load(t.normal[c] + p), n_q = load(t.normal[c] + q);
        const real way = load(t.position[c] + q) - load(t.position[c] + p);
        normals += square(n_p - n_q);
        albedos += square(load(t.albedo[c] + p) - load(t.albedo[c] + q));
        from_p += n_p * way;
        from_q += n_q * way;
        length2 += square(way);
    }
    constexpr float unit = normal_bandwidth * normal_bandwidth;  // the stored normal is divided by its bandwidth
    const real to_plane = min(square(from_p), square(from_q)) * real(unit);
    return max(max(to_plane / (length2 * real(plane_bandwidth2) + real(least)), normals), albedos);
}

/// The variance of each pixel of the patches, averaged over similar neighbors.
static void smooth_variance(Tile& t) {
    constexpr int reach = search_radius + patch_radius;
    for (int y = -reach; y < t.height + reach; ++y)
        for (int x = -reach; x < t.width + reach; x += lanes) {
            const int p = at(x, y);
            real sums[3] = {0.0f, 0.0f, 0.0f}, weights = 0.0f;
            for (int dy = -variance_radius; dy <= variance_radius; ++dy)
                for (int dx = -variance_radius; dx <= variance_radius; ++dx) {
                    const int q = p + dy * stride + dx;
                    const real near = real(1.0f / float(1 + (dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy)));
                    const real weight = exp(-feature_distance(t, p, q)) * near * load(t.valid + q);
                    weights += weight;
                    for (int c = 0; c < 3; ++c) sums[c] += weight * load(t.variance[c] + q);
                }
            const real scale = select(weights > real(0.0f), reciprocal(weights), real(0.0f));
            for (int c = 0; c < 3; ++c) store(t.smooth_variance[c] + p, sums[c] * scale);
        }
}

/// The distances of single pixels at one offset: row y + patch_radius of `distances` is the tile's row y.
static void find_distances(Tile& t, int offset) {
    for (int y = -patch_radius; y < t.height + patch_radius; ++y)
        for (int x = -patch_radius; x < t.width + patch_radius; x += lanes) {
            const int p = at(x, y);
            store(t.distances + (y + patch_radius) * stride + x + patch_radius, pixel_distance(t, p, p + offset));
        }
}

/// Sums over the columns of the patches of one row.
static void sum_columns(const Tile& t, int y, float* sums) {
    const float* const top = t.distances + y * stride;
    for (int x = 0; x < t.width + 2 * patch_radius; x += lanes) {
        real sum = load(top + x);
        for (int row = 1; row <= 2 * patch_radius; ++row) sum += load(top + row * stride + x);
        store(sums + x, sum);
    }
}

/// Adds the neighbor at one offset to the sums of all pixels.
static void add_neighbor(Tile& t, int offset) {
    constexpr int side = 2 * patch_radius + 1;
    float columns[stride] = {};
    for (int y = 0; y < t.height; ++y) {
        sum_columns(t, y, columns);
        for (int x = 0; x < t.width; x += lanes) {
            real patches = load(columns + x);
            for (int i = 1; i < side; ++i) patches += load(columns + x + i);
            const int p = at(x, y), q = p + offset, to = y * tile_width + x;
            const real colors = max(patches * real(1.0f / float(3 * side * side)), real(0.0f));
            const real weight = exp(-max(feature_distance(t, p, q), colors)) * load(t.valid + q);
            for (int c = 0; c < 3; ++c) store(t.sum[c] + to, load(t.sum[c] + to) + weight * load(t.light[c] + q));
            store(t.sum[3] + to, load(t.sum[3] + to) + weight);
        }
    }
}

void sum_neighbors(Tile& t) {
    smooth_variance(t);
    for (int dy = -search_radius; dy <= search_radius; ++dy)
        for (int dx = -search_radius; dx <= search_radius; ++dx) {
            if (dx * dx + dy * dy > search_radius * (search_radius + 1)) continue;
            find_distances(t, dy * stride + dx);
            add_neighbor(t, dy * stride + dx);
        }
}

}  // namespace rakelight::denoise::RL_ISA
