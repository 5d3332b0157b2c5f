// SPDX-License-Identifier: Apache-2.0
// The end of a multisampled tile: blended surfaces sample by sample, the mean of the samples, lines and points.
#include <optional>

#include "engines/raster/marks/mark_layers.h"
#include "engines/raster/multisample.h"
#include "engines/raster/shade/blend_tile.h"
#include "image/tone.h"

namespace rakelight::raster {
namespace {

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
        lay_blended(job, tile, blending_order(job, tile), marks ? &*marks : nullptr, job.front.settings.samples, s);
        if (job.is_cancelled()) return;
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
