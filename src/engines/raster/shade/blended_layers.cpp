// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/shade/blended_layers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "engines/raster/blend.h"
#include "engines/raster/marks/mark_layers.h"
#include "engines/raster/multisample.h"
#include "engines/raster/visibility/coverage.h"

namespace rakelight::raster {
namespace {

constexpr std::size_t most_kept = 1 << 17;  ///< places that stay for the next tile
constexpr std::size_t most_together = 8;  ///< pixels whose sums are made side by side, as each waits for its last term
constexpr std::size_t most_fragments = BlendedLayers::most_waiting * std::size_t(shading::most_samples);

LayerPlace place_of(const BlendedFragment& f) { return {f.key, f.number}; }

void lay_over_samples(vec4 color, std::uint32_t samples, vec4* colors) {
    for (; samples != 0; samples &= samples - 1) lay_over(color, colors[std::countr_zero(samples)]);
}

bool is_farther_at_all_samples(const BlendedFragment& a, const BlendedFragment& b) {
    return a.key + a.reach < (b.key - b.reach) * (1 - 2 * equal_depths);
}

/// Farthest first: none comes before another at any sample that both cover.
bool is_order_of_all_samples(std::span<const WaitingLayer> layers) {
    for (std::size_t i = 1; i < layers.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const BlendedFragment &a = *layers[k].fragment, &b = *layers[i].fragment;
            if ((a.samples & b.samples) != 0 && !is_farther_at_all_samples(a, b)) return false;
        }
    return true;
}

LayerPlace waiting_place(const WaitingLayer& layer) { return layer.place; }

/// The batch arrays, so that the compiler keeps their places in registers.
struct BatchColors {
    const float *red, *green, *blue, *alpha;
    std::uint64_t not_finite = 0;

    explicit BatchColors(const TileScratch& s)
        : red(s.red.data()), green(s.green.data()), blue(s.blue.data()), alpha(s.alpha.data()) {}
    vec4 at(std::size_t i) {
        const bool is_finite = alpha[i] - alpha[i] == 0;
        not_finite += std::uint64_t(!is_finite);
        return {red[i], green[i], blue[i], is_finite ? std::clamp(alpha[i], 0.0f, 1.0f) : 0.0f};
    }
};

}  // namespace

BlendedLayers::BlendedLayers(const TileJob& job, std::size_t tile, TileScratch& scratch, MarkLayers* marks, int samples)
    : job_(job),
      s_(scratch),
      m_(*scratch.layers),
      marks_(marks),
      items_(job.binned.items.data() + job.binned.offsets[tile]),
      ox_(job.grid.origin_x(tile)),
      oy_(job.grid.origin_y(tile)),
      samples_(std::size_t(samples)),
      is_plain_(!marks && (samples > 1 || !scratch.on_layer)) {
    charged_ = m_.waiting.size() * sizeof(LayerScratch::Waiting);
    job_.front.memory.add(charged_);
    m_.laid.clear();
}

BlendedLayers::~BlendedLayers() {
    clear();
    if (m_.waiting.size() > most_kept) m_.waiting = {};
    job_.front.memory.remove(charged_);
}

void BlendedLayers::clear() {
    for (std::size_t i = 0; i < pixels_; ++i) {
        m_.last[m_.pixels[i]] = no_index;
        m_.count[m_.pixels[i]] = 0;
    }
    pixels_ = used_ = 0;
    free_ = no_index;
}

vec4* BlendedLayers::sample_colors(std::size_t pixel) const {
    if (samples_ == 1) return &s_.color[pixel];
    return &s_.samples->color[std::size_t(s_.samples->number[pixel]) * samples_];
}

template <class Take>
void BlendedLayers::for_each_fragment(const BatchPart& part, const Take& take) {
    BatchColors colors(s_);
    const std::int32_t* const pixel = s_.pixel.data();
    const float* const depth = s_.batch_depth.data();
    const std::uint16_t* const masks = m_.batch_masks.data();
    for (std::size_t i = part.begin; i < part.end; ++i)
        take(BlendedFragment{colors.at(i), depth[i], part.reach, part.number, std::uint16_t(pixel[i]),
                             samples_ == 1 ? std::uint16_t(1) : masks[i]});
    s_.not_finite += colors.not_finite;
}

void BlendedLayers::lay(const BatchPart& part) {
    if (!is_plain_) {
        for_each_fragment(part, [this](const BlendedFragment& f) { lay(f); });
    } else if (samples_ == 1) {
        vec4* const to = s_.color.data();
        for_each_fragment(part, [to](const BlendedFragment& f) { lay_over(f.color, to[f.pixel]); });
    } else {
        for_each_fragment(
            part, [this](const BlendedFragment& f) { lay_over_samples(f.color, f.samples, sample_colors(f.pixel)); });
    }
}

void BlendedLayers::lay(const BlendedFragment& f) {
    vec4* const colors = sample_colors(f.pixel);
    if (marks_) marks_->lay_behind(triangle(f.number), f.pixel, colors, samples_);
    lay_over_samples(f.color, f.samples, colors);
    if (samples_ == 1 && s_.on_layer) s_.on_layer(f.pixel, f.number, f.color.w);
}

void BlendedLayers::make_room(std::size_t count) {
    if (used_ + count <= m_.waiting.size()) return;
    constexpr std::size_t size = sizeof(LayerScratch::Waiting);
    const std::size_t room = std::max<std::size_t>(used_ + count, 2 * m_.waiting.size());
    job_.front.memory.add(room * size);  // the old ones live until they are copied
    m_.waiting.resize(room);
    job_.front.memory.remove(std::exchange(charged_, room * size));
}

void BlendedLayers::wait(const BatchPart& part) {
    make_room(part.end - part.begin);
    LayerScratch::Waiting* const waiting = m_.waiting.data();
    std::uint32_t* const last = m_.last.data();
    std::uint16_t *const counts = m_.count.data(), *const pixels = m_.pixels.data();
    const std::size_t most = most_waiting * samples_;
    std::size_t used = used_, count_of_pixels = pixels_;
    for_each_fragment(part, [&](const BlendedFragment& f) {
        if (last[f.pixel] == no_index) pixels[count_of_pixels++] = f.pixel;
        const auto place = free_ == no_index ? std::uint32_t(used++) : std::exchange(free_, waiting[free_].next);
        waiting[place] = {f, std::exchange(last[f.pixel], place)};
        counts[f.pixel] = std::uint16_t(counts[f.pixel] + weight(f));
        if (counts[f.pixel] > most) lay_early(f);
    });
    used_ = used, pixels_ = count_of_pixels;
}

/// The farthest, until not too many wait.
void BlendedLayers::lay_early(const BlendedFragment& added) {
    if (m_.laid.empty()) m_.laid.assign(tile_pixels, {-1, 0});
    LayerPlace& laid = m_.laid[added.pixel];
    if (is_laid_before(place_of(added), laid)) ++s_.layers_unsorted;
    while (m_.count[added.pixel] > most_waiting * samples_) {
        std::uint32_t* link = &m_.last[added.pixel];
        for (std::uint32_t* next = &m_.waiting[*link].next; *next != no_index; next = &m_.waiting[*next].next)
            if (is_laid_before(place_of(m_.waiting[*next].fragment), place_of(m_.waiting[*link].fragment))) link = next;
        const std::uint32_t place = *link;
        const BlendedFragment& farthest = m_.waiting[place].fragment;
        *link = std::exchange(m_.waiting[place].next, std::exchange(free_, place));
        if (!is_laid_before(place_of(farthest), laid)) laid = place_of(farthest);
        lay(farthest);
        m_.count[added.pixel] = std::uint16_t(m_.count[added.pixel] - weight(farthest));
    }
}

void BlendedLayers::finish() {
    const auto pixels = std::span<const std::uint16_t>(m_.pixels).first(pixels_);
    for (std::size_t begin = 0; begin < pixels.size(); begin += most_together) {
        if (begin % tile_size == 0 && job_.is_cancelled()) return;
        const auto some = pixels.subspan(begin, std::min(most_together, pixels.size() - begin));
        if (samples_ == 1 && is_plain_)
            finish_plain(some);
        else
            for (const std::uint16_t p : some) finish_pixel(p);
    }
    clear();
}

/// What waits at a pixel, far to near. It came far to near or the other way round, but for what crosses.
std::span<const WaitingLayer> BlendedLayers::sorted(std::size_t pixel, WaitingLayer* end) const {
    WaitingLayer* begin = end;
    for (std::uint32_t place = m_.last[pixel]; place != no_index; place = m_.waiting[place].next) {
        const BlendedFragment& f = m_.waiting[place].fragment;
        *--begin = {place_of(f), &f};
    }
    if (is_laid_before(end[-1].place, begin->place)) std::reverse(begin, end);
    for (WaitingLayer* last = begin + 1; last < end; ++last) insert_last_layer(begin, last + 1, waiting_place);
    return {begin, end};
}

void BlendedLayers::finish_plain(std::span<const std::uint16_t> pixels) {
    WaitingLayer all[most_together][most_waiting];
    std::span<const WaitingLayer> layers[most_together];
    vec4 colors[most_together];
    std::size_t most = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        layers[i] = sorted(pixels[i], std::end(all[i]));
        colors[i] = s_.color[pixels[i]];
        most = std::max(most, layers[i].size());
    }
    for (std::size_t k = 0; k < most; ++k)
        for (std::size_t i = 0; i < pixels.size(); ++i)
            if (k < layers[i].size()) lay_over(layers[i][k].fragment->color, colors[i]);
    for (std::size_t i = 0; i < pixels.size(); ++i) s_.color[pixels[i]] = colors[i];
}

void BlendedLayers::finish_pixel(std::size_t pixel) {
    WaitingLayer all[most_fragments];
    const std::span<const WaitingLayer> layers = sorted(pixel, std::end(all));
    // Marks lie between surfaces on all samples of a pixel.
    const bool is_one_order = samples_ == 1 || (marks_ && marks_->has_any(pixel)) || is_order_of_all_samples(layers);
    if (!is_one_order) return lay_by_samples(layers);
    for (const WaitingLayer& layer : layers) lay(*layer.fragment);
}

void BlendedLayers::lay_by_samples(std::span<const WaitingLayer> waiting) {
    const auto positions = sample_positions(int(samples_));
    const std::size_t pixel = waiting[0].fragment->pixel;
    vec4* const colors = sample_colors(pixel);
    KeyPlane planes[most_fragments];
    for (std::size_t i = 0; i < waiting.size(); ++i) set_plane(triangle(waiting[i].place.number), ox_, oy_, planes[i]);
    for (std::size_t k = 0; k < samples_; ++k) {
        const float x = float(pixel % tile_size) + float(positions[k].x) / 16,
                    y = float(pixel / tile_size) + float(positions[k].y) / 16;
        WaitingLayer layers[most_fragments];
        WaitingLayer* end = layers;
        for (std::size_t i = 0; i < waiting.size(); ++i) {
            const BlendedFragment* const f = waiting[i].fragment;
            if (!(f->samples >> k & 1u)) continue;
            *end++ = {{depth_at(planes[i], x, y), f->number}, f};
            insert_last_layer(layers, end, waiting_place);
        }
        for (const WaitingLayer* layer = layers; layer != end; ++layer) lay_over(layer->fragment->color, colors[k]);
    }
}

}  // namespace rakelight::raster
