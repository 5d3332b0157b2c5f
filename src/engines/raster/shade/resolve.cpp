// SPDX-License-Identifier: Apache-2.0
// The end of a multisampled tile: blended surfaces sample by sample, the mean of the samples, lines and points.
#include <algorithm>
#include <bit>
#include <optional>

#include "engines/raster/blend.h"
#include "engines/raster/marks/mark_layers.h"
#include "engines/raster/multisample.h"
#include "engines/raster/visibility/coverage.h"
#include "image/tone.h"

namespace rakelight::raster {
namespace {

/// Blends a triangle, shaded once per pixel, over those of its samples where it is nearest. At an edge that two
/// triangles share, no sample gets both, so the surface has no seam.
/// @param shown  [tile_pixels] all 0, and again after
/// @param marks  lines and points between the surfaces, if there are any
void blend_triangle(const TileJob& job, std::size_t tile, const ScreenTriangle& t, MarkLayers* marks,
                    std::vector<std::uint16_t>& sample_masks, TileScratch& s) {
    SampleScratch& m = *s.samples;
    const auto positions = sample_positions(job.front.settings.samples);
    const int ox = job.grid.origin_x(tile), oy = job.grid.origin_y(tile);
    std::size_t count = 0;
    for (std::size_t k = 0; k < positions.size(); ++k)
        cover(seen_from(positions[k], t), job.grid.pixels(tile), ox, oy, [&](int x, int y, float depth) {
            const auto p = std::size_t(y * tile_size + x);
            if (!(depth > m.depth[k * tile_pixels + p])) return;
            if (sample_masks[p] == 0) s.pixel[count++] = std::int32_t(p);
            sample_masks[p] = std::uint16_t(sample_masks[p] | 1u << k);
        });
    if (count == 0) return;
    for (std::size_t i = 0; i < count; ++i) {
        s.batch_triangle[i] = 0;
        move_to_middle(job.front.settings.samples, sample_masks[std::size_t(s.pixel[i])], i, s);
    }
    const ScreenTriangle* const only = &t;
    make_records(job, t.draw, {&only, 1}, ox, oy, s);
    ShadeJob batch = make_job(job, t.draw, ox, oy, count, s);
    use_offsets(batch, s);
    s.not_finite += std::uint64_t(shade_with_lists(job.kernels, job.reach, batch, s));
    s.shaded += count;
    if (!batch.unlit && !batch.lit) s.lit_pixels += count;
    if (marks) marks->lay_behind_samples(t, count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto p = std::size_t(s.pixel[i]);
        const bool is_finite = s.alpha[i] - s.alpha[i] == 0;
        if (!is_finite) ++s.not_finite;
        const vec4 c = {s.red[i], s.green[i], s.blue[i], is_finite ? std::clamp(s.alpha[i], 0.0f, 1.0f) : 0.0f};
        vec4* const colors = &m.color[std::size_t(m.number[p]) * positions.size()];
        for (std::uint32_t left = sample_masks[p]; left != 0; left &= left - 1)
            lay_over(c, colors[std::countr_zero(left)]);
        sample_masks[p] = 0;
    }
}

void resolve(bool is_direct, std::size_t samples, TileScratch& s) {
    SampleScratch& m = *s.samples;
    const std::size_t count = m.open_pixels.size();
    m.resolved.resize(count);
    for (std::size_t n = 0; n < count; ++n) m.resolved[n] = mean_of_samples(&m.color[n * samples], samples);
    if (!is_direct) {
        for (std::size_t n = 0; n < count; ++n) s.color[std::size_t(m.open_pixels[n])] = m.resolved[n];
        return;
    }
    m.codes.resize(count);
    to_srgb8(m.resolved, 4, {reinterpret_cast<std::uint8_t*>(m.codes.data()), 4 * count});
    for (std::size_t n = 0; n < count; ++n) {
        const auto p = std::size_t(m.open_pixels[n]);
        s.display.first[p / tile_size * s.display.stride + p % tile_size] = m.codes[n];
    }
}

}  // namespace

void finish_samples(const TileJob& job, std::size_t tile, TileScratch& s) {
    const bool has_any_marks = has_marks(job, tile);
    std::optional<MarkLayers> marks;
    if (s.samples->blends) {
        if (has_any_marks) marks.emplace(job, tile, s);
        std::vector<std::uint16_t> sample_masks(tile_pixels, 0);
        for (const std::uint32_t item : blending_order(job, tile)) {
            if (job.is_cancelled()) return;
            blend_triangle(job, tile, *job.binned.items[item], marks ? &*marks : nullptr, sample_masks, s);
        }
    }
    resolve(job.to_srgb8 && !has_any_marks, std::size_t(job.front.settings.samples), s);
    if (!has_any_marks) return;
    if (marks)
        marks->lay_rest();
    else
        draw_marks(job, tile, s);
    if (job.to_srgb8) encode_tile(s);
}

}  // namespace rakelight::raster
