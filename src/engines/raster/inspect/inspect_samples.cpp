// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/inspect/inspect_samples.h"

#include <algorithm>
#include <span>

#include "engines/raster/inspect/note_samples.h"
#include "engines/raster/inspect/open_scene.h"
#include "engines/raster/multisample.h"
#include "math/flush_denormals.h"

namespace rakelight::raster {
namespace {

static_assert(sample_square == tile_size);

/// The colors of a pixel's samples in a finished tile; one where they are all the same triangle's.
std::span<const vec4> sample_colors(const TileScratch& s, std::size_t pixel, std::size_t samples) {
    const SampleScratch& m = *s.samples;
    if (m.whole[pixel] != is_open) return {&s.color[pixel], 1};
    return {&m.color[std::size_t(m.number[pixel]) * samples], samples};
}

/// Calls visit(pixel of the tile, pixel of the picture).
template <class Visit>
void for_each_pixel(const TileJob& job, std::size_t tile, int width, const Visit& visit) {
    const Window area = job.grid.pixels(tile);
    const int ox = job.grid.origin_x(tile), oy = job.grid.origin_y(tile);
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = area.x; x < area.x + area.width; ++x)
            visit(std::size_t((y - oy) * tile_size + x - ox), std::size_t(y) * std::size_t(width) + std::size_t(x));
}

void draw(const TileJob& job, std::size_t tile, TileScratch& s) {
    find_visible_samples(job, tile, s);
    shade_samples(job, tile, s);
    finish_samples(job, tile, s);
}

/// How many samples something opaque covers, and how many triangles they show.
void count(const SampleScratch& m, std::size_t pixel, std::size_t samples, std::uint8_t& covered,
           std::uint8_t& triangles) {
    std::int32_t shown[shading::most_samples];
    for (std::size_t k = 0; k < samples; ++k) {
        const std::int32_t position = m.visible[k * tile_pixels + pixel];
        if (position < 0) continue;
        ++covered;
        if (std::find(shown, shown + triangles, position) == shown + triangles) shown[triangles++] = position;
    }
}

float spread(std::span<const vec4> colors) {
    const auto component = [&](float vec4::*c) {
        float low = 1, high = 0;
        for (const vec4& color : colors) {
            const float v = std::min(color.*c, 1.0f);
            low = std::min(low, v), high = std::max(high, v);
        }
        return std::max(high - low, 0.0f);
    };
    return std::max({component(&vec4::x), component(&vec4::y), component(&vec4::z)});
}

}  // namespace

void note_samples(const TileJob& job, std::size_t tile, const RenderSettings& settings, TileScratch& s,
                  PixelStageData& out) {
    const auto samples = std::size_t(settings.samples);
    draw(job, tile, s);
    for_each_pixel(job, tile, settings.width, [&](std::size_t pixel, std::size_t p) {
        count(*s.samples, pixel, samples, out.samples_covered[p], out.visible_triangles[p]);
        out.color[p] = s.color[pixel];
        out.sample_spread[p] = spread(sample_colors(s, pixel, samples));
    });
}

SampleColors inspect_samples(const Inspection& inspection, const Inspection::Geometry& geometry, Window window) {
    const OpenScene& of = inspection.opened();
    const OpenGeometry& drawn = geometry.opened();
    const FlushDenormals guard;
    const auto samples = std::size_t(of.settings().samples);
    SampleColors out{window, {}};
    for (std::size_t tile = 0; tile < drawn.grid.count(); ++tile) {
        const Window area = drawn.grid.pixels(tile);
        if (window.x < area.x || window.x >= area.x + area.width || window.y < area.y ||
            window.y >= area.y + area.height)
            continue;
        TileJob job = tile_job(of, drawn);
        job.marks =
            nullptr;  // they are laid over the means of samples, except behind glass, where only surfaces are shown
        TileScratch s;
        draw(job, tile, s);
        for (int y = window.y - drawn.grid.origin_y(tile), y_end = y + window.height; y < y_end; ++y)
            for (int x = window.x - drawn.grid.origin_x(tile), x_end = x + window.width; x < x_end; ++x) {
                const auto colors = sample_colors(s, std::size_t(y * tile_size + x), samples);
                for (std::size_t k = 0; k < samples; ++k) out.color.push_back(colors[colors.size() == 1 ? 0 : k]);
            }
    }
    return out;
}

}  // namespace rakelight::raster
