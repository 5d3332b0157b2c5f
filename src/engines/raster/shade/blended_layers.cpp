// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/shade/blended_layers.h"

#include <bit>
#include <utility>

#include "engines/raster/blend.h"
#include "engines/raster/marks/mark_layers.h"
#include "engines/raster/multisample.h"
#include "engines/raster/visibility/coverage.h"

namespace rakelight::raster {
namespace {

constexpr std::size_t most_kept = 1 << 15;  ///< places that stay for the next tile

LayerPlace place_of(const BlendedFragment& f) { return {f.key, f.number}; }

/// Farthest first: none comes before another at any sample of the pixel.
bool is_order_of_all_samples(const BlendedFragment* const* fragments, std::size_t count) {
    float nearest = fragments[0]->key + fragments[0]->reach;
    for (std::size_t i = 1; i < count; ++i) {
        const BlendedFragment& f = *fragments[i];
        if (!(nearest < (f.key - f.reach) * (1 - 2 * equal_depths))) return false;
        nearest = std::max(nearest, f.key + f.reach);
    }
    return true;
}

}  // namespace

BlendedLayers::BlendedLayers(const TileJob& job, std::size_t tile, TileScratch& scratch, MarkLayers* marks, int samples)
    : job_(job),
      s_(scratch),
      m_(*scratch.layers),
      marks_(marks),
      items_(job.binned.items.data() + job.binned.offsets[tile]),
      ox_(job.grid.origin_x(tile)),
      oy_(job.grid.origin_y(tile)),
      samples_(std::size_t(samples)) {
    job_.front.memory.add(m_.waiting.capacity() * sizeof(LayerScratch::Waiting));
    charged_ = m_.waiting.capacity() * sizeof(LayerScratch::Waiting);
    m_.waiting.clear();
    m_.laid.clear();
    std::fill(m_.first.begin(), m_.first.end(), no_index);
    std::fill(m_.count.begin(), m_.count.end(), std::uint8_t(0));
}

BlendedLayers::~BlendedLayers() {
    if (m_.waiting.capacity() > most_kept) m_.waiting = {};
    job_.front.memory.remove(charged_);
}

void BlendedLayers::lay(const BlendedFragment& f) {
    vec4* const colors =
        samples_ == 1 ? &s_.color[f.pixel] : &s_.samples->color[std::size_t(s_.samples->number[f.pixel]) * samples_];
    if (marks_) marks_->lay_behind(triangle(f.number), f.pixel, colors, samples_);
    if (samples_ == 1) {
        lay_over(f.color, *colors);
    } else {
        for (std::uint32_t left = f.samples; left != 0; left &= left - 1)
            lay_over(f.color, colors[std::countr_zero(left)]);
    }
    if (samples_ == 1 && s_.on_layer) s_.on_layer(f.pixel, f.number, f.color.w);
}

std::uint32_t BlendedLayers::place_for(const BlendedFragment& f) {
    if (free_ != no_index) {
        const std::uint32_t place = free_;
        free_ = m_.waiting[place].next;
        m_.waiting[place].fragment = f;
        return place;
    }
    if (m_.waiting.size() == m_.waiting.capacity()) {
        constexpr std::size_t size = sizeof(LayerScratch::Waiting);
        const std::size_t room = std::max<std::size_t>(tile_pixels, 2 * m_.waiting.size());
        job_.front.memory.add(room * size);  // the old ones live until they are copied
        m_.waiting.reserve(room);
        job_.front.memory.remove(std::exchange(charged_, room * size));
    }
    m_.waiting.push_back({f, no_index});
    return std::uint32_t(m_.waiting.size() - 1);
}

void BlendedLayers::wait(const BlendedFragment& f) {
    const std::uint32_t place = place_for(f);
    std::uint32_t* link = &m_.first[f.pixel];
    while (*link != no_index && is_laid_before(place_of(f), place_of(m_.waiting[*link].fragment)))
        link = &m_.waiting[*link].next;
    m_.waiting[place].next = *link;
    *link = place;
    if (++m_.count[f.pixel] > most_waiting) lay_farthest(f);
}

void BlendedLayers::lay_farthest(const BlendedFragment& added) {
    if (m_.laid.empty()) m_.laid.assign(tile_pixels, {-1, 0});
    LayerPlace& laid = m_.laid[added.pixel];
    if (is_laid_before(place_of(added), laid)) ++s_.layers_unsorted;
    std::uint32_t* link = &m_.first[added.pixel];
    while (m_.waiting[*link].next != no_index) link = &m_.waiting[*link].next;
    const std::uint32_t place = std::exchange(*link, no_index);
    const BlendedFragment& farthest = m_.waiting[place].fragment;
    if (!is_laid_before(place_of(farthest), laid)) laid = place_of(farthest);
    lay(farthest);
    m_.waiting[place].next = std::exchange(free_, place);
    --m_.count[added.pixel];
}

void BlendedLayers::finish() {
    for (std::size_t p = 0; p < tile_pixels; ++p) {
        if (p % tile_size == 0 && job_.is_cancelled()) return;
        if (m_.first[p] != no_index) finish_pixel(p);
    }
}

void BlendedLayers::finish_pixel(std::size_t pixel) {
    const BlendedFragment* fragments[most_waiting];
    const std::size_t count = m_.count[pixel];
    std::uint32_t place = m_.first[pixel];
    for (std::size_t i = count; i-- > 0; place = m_.waiting[place].next) fragments[i] = &m_.waiting[place].fragment;
    // Marks lie between surfaces on all samples of a pixel.
    const bool is_one_order =
        samples_ == 1 || (marks_ && marks_->has_any(pixel)) || is_order_of_all_samples(fragments, count);
    if (!is_one_order) return lay_by_samples(fragments, count);
    for (std::size_t i = 0; i < count; ++i) lay(*fragments[i]);
}

void BlendedLayers::lay_by_samples(const BlendedFragment* const* fragments, std::size_t count) {
    const auto positions = sample_positions(int(samples_));
    const std::size_t pixel = fragments[0]->pixel;
    vec4* const colors = &s_.samples->color[std::size_t(s_.samples->number[pixel]) * samples_];
    Coverage planes[most_waiting];
    for (std::size_t i = 0; i < count; ++i) set_plane(triangle(fragments[i]->number), ox_, oy_, planes[i]);
    for (std::size_t k = 0; k < samples_; ++k) {
        const float x = float(pixel % tile_size) + float(positions[k].x) / 16,
                    y = float(pixel / tile_size) + float(positions[k].y) / 16;
        struct Layer {
            LayerPlace place;
            const vec4* color;
        };
        Layer layers[most_waiting];
        std::size_t covering = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (!(fragments[i]->samples >> k & 1u)) continue;
            layers[covering++] = {{depth_at(planes[i], x, y), fragments[i]->number}, &fragments[i]->color};
            insert_last_layer(layers, layers + covering, [](const Layer& layer) { return layer.place; });
        }
        for (std::size_t i = 0; i < covering; ++i) lay_over(*layers[i].color, colors[k]);
    }
}

}  // namespace rakelight::raster
