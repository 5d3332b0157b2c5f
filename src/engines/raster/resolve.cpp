// SPDX-License-Identifier: Apache-2.0
// The end of a multisampled tile: blended surfaces sample by sample, the mean of the samples, lines and points.
#include <algorithm>
#include <bit>

#include "engines/raster/coverage.h"
#include "engines/raster/multisample.h"
#include "image/tone.h"

namespace rakelight::raster {
namespace {

/// Porter & Duff 1984, straight alpha: what blend_batch() of shade_tile.cpp does to a pixel.
void lay(vec4 c, vec4& to) {
    const float under = to.w * (1 - c.w), alpha = c.w + under;
    if (alpha > 0)
        to = {(c.x * c.w + to.x * under) / alpha, (c.y * c.w + to.y * under) / alpha,
              (c.z * c.w + to.z * under) / alpha, alpha};
}

/// A blended triangle, shaded once a pixel, over those of its samples where it is nearer than what stands there: at an
/// edge that two triangles share no sample gets both, so that the surface has no seam.
/// @param shown  [tile_pixels] all 0, and again after
void blend_triangle(const TileJob& job, std::size_t tile, const ScreenTriangle& t, std::vector<std::uint16_t>& shown,
                    TileScratch& s) {
    SampleScratch& m = *s.samples;
    const auto positions = sample_positions(job.front.settings.samples);
    const int ox = job.grid.origin_x(tile), oy = job.grid.origin_y(tile);
    std::size_t count = 0;
    for (std::size_t k = 0; k < positions.size(); ++k)
        cover(seen_from(positions[k], t), job.grid.pixels(tile), ox, oy, [&](int x, int y, float depth) {
            const auto p = std::size_t(y * tile_size + x);
            if (!(depth > m.depth[k * tile_pixels + p])) return;
            if (shown[p] == 0) s.pixel[count++] = std::int32_t(p);
            shown[p] = std::uint16_t(shown[p] | 1u << k);
        });
    if (count == 0) return;
    for (std::size_t i = 0; i < count; ++i) {
        s.triangle[i] = 0;
        move_to_middle(job.front.settings.samples, shown[std::size_t(s.pixel[i])], i, s);
    }
    const ScreenTriangle* const only = &t;
    make_records(job, t.draw, {&only, 1}, ox, oy, s);
    ShadeJob batch = make_job(job, t.draw, ox, oy, count, s);
    use_offsets(batch, s);
    s.not_finite += std::uint64_t(job.kernels.shade(&batch));
    s.shaded += count;
    if (!batch.unlit && !batch.lit) s.lit_pixels += count;
    for (std::size_t i = 0; i < count; ++i) {
        const auto p = std::size_t(s.pixel[i]);
        const bool is_finite = s.alpha[i] - s.alpha[i] == 0;
        if (!is_finite) ++s.not_finite;
        const vec4 c = {s.red[i], s.green[i], s.blue[i], is_finite ? std::clamp(s.alpha[i], 0.0f, 1.0f) : 0.0f};
        vec4* const colors = &m.color[std::size_t(m.number[p]) * positions.size()];
        for (std::uint32_t left = shown[p]; left != 0; left &= left - 1) lay(c, colors[std::countr_zero(left)]);
        shown[p] = 0;
    }
}

/// The mean of n colors, each by its alpha. Sums in double: of equal ones it is the color itself, to the bit.
vec4 mean(const vec4* colors, std::size_t n) {
    double r = 0, g = 0, b = 0, a = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double alpha = double(colors[i].w);
        r += double(colors[i].x) * alpha, g += double(colors[i].y) * alpha, b += double(colors[i].z) * alpha,
            a += alpha;
    }
    if (!(a > 0)) return {colors[0].x, colors[0].y, colors[0].z, 0};  // nothing is there: the background's own
    return {float(r / a), float(g / a), float(b / a), float(a / double(n))};
}

void resolve(bool is_direct, std::size_t samples, TileScratch& s) {
    SampleScratch& m = *s.samples;
    const std::size_t count = m.open_pixels.size();
    m.resolved.resize(count);
    for (std::size_t n = 0; n < count; ++n) m.resolved[n] = mean(&m.color[n * samples], samples);
    if (!is_direct) {
        for (std::size_t n = 0; n < count; ++n) s.color[std::size_t(m.open_pixels[n])] = m.resolved[n];
        return;
    }
    m.codes.resize(count);
    to_srgb8(m.resolved, 4, {reinterpret_cast<std::uint8_t*>(m.codes.data()), 4 * count});
    for (std::size_t n = 0; n < count; ++n) s.srgb8[std::size_t(m.open_pixels[n])] = m.codes[n];
}

}  // namespace

void finish_samples(const TileJob& job, std::size_t tile, TileScratch& s) {
    if (s.samples->blends) {
        std::vector<std::uint16_t> shown(tile_pixels, 0);
        for (const std::uint32_t item : blending_order(job, tile))
            blend_triangle(job, tile, job.binned.at(job.binned.items[item]), shown, s);
    }
    const bool marks = has_marks(job, tile);
    resolve(job.to_srgb8 && !marks, std::size_t(job.front.settings.samples), s);
    if (!marks) return;
    draw_marks(job, tile, s);
    if (job.to_srgb8) to_srgb8(s.color, 4, {reinterpret_cast<std::uint8_t*>(s.srgb8.data()), 4 * s.srgb8.size()});
}

}  // namespace rakelight::raster
