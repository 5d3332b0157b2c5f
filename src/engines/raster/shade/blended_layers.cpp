// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/shade/blended_layers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "engines/raster/blend.h"
#include "engines/raster/marks/mark_layers.h"
#include "engines/raster/multisample.h"

namespace rakelight::raster {
namespace {

constexpr std::size_t most_kept = 1 << 17;  ///< places that stay for the next tile
constexpr std::size_t most_together = 8;  ///< pixels whose sums are made side by side, as each waits for its last term
constexpr std::size_t waiting_size = sizeof(LayerScratch::Waiting) + sizeof(vec4);  ///< [bytes]
constexpr std::size_t most_fragments = BlendedLayers::most_waiting * std::size_t(shading::most_samples);

void lay_over_samples(vec4 color, std::uint32_t samples, vec4* colors) {
    for (; samples != 0; samples &= samples - 1) lay_over(color, colors[std::countr_zero(samples)]);
}

LayerPlace place_of(const SortedLayer& layer) { return layer.place; }

/// To 0..1; what is not finite becomes 0.
/// @returns how many were not finite
std::uint64_t limit_alphas(std::span<float> alphas) {
    std::uint64_t not_finite = 0;
    for (float& alpha : alphas) {
        if (alpha >= 0 && alpha <= 1) continue;
        const bool is_finite = alpha - alpha == 0;
        not_finite += std::uint64_t(!is_finite);
        alpha = is_finite ? std::clamp(alpha, 0.0f, 1.0f) : 0.0f;
    }
    return not_finite;
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
      samples_(std::size_t(samples)),
      is_plain_(!marks && (samples > 1 || !scratch.on_layer)) {
    charged_ = m_.waiting.size() * waiting_size;
    job_.front.memory.add(charged_);
    m_.laid.clear();
    if (samples > 1) m_.planes.resize(job.binned.offsets[tile + 1] - job.binned.offsets[tile]);
}

BlendedLayers::~BlendedLayers() {
    clear();
    if (m_.waiting.size() > most_kept) m_.waiting = {}, m_.colors = {};
    job_.front.memory.remove(charged_);
}

void BlendedLayers::clear() {
    for (std::size_t i = 0; i < pixels_; ++i) {
        m_.last[m_.pixels[i]] = no_index;
        m_.count[m_.pixels[i]] = 0;
    }
    pixels_ = used_ = parts_ = 0;
    free_ = no_index;
}

vec4* BlendedLayers::sample_colors(std::size_t pixel) const {
    if (samples_ == 1) return &s_.color[pixel];
    return &s_.samples->color[std::size_t(s_.samples->number[pixel]) * samples_];
}

template <class Take>
void BlendedLayers::for_each_fragment(const BatchPart& part, const Take& take) {
    s_.not_finite += limit_alphas(std::span(s_.alpha).subspan(part.begin, part.end - part.begin));
    const float *const red = s_.red.data(), *const green = s_.green.data(), *const blue = s_.blue.data(),
                       *const alpha = s_.alpha.data();
    const std::int32_t* const pixel = s_.pixel.data();
    const float* const depth = s_.batch_depth.data();
    const std::uint16_t* const masks = m_.batch_masks.data();
    const bool is_one_sample = samples_ == 1;
    for (std::size_t i = part.begin; i < part.end; ++i)
        take(BlendedFragment{{red[i], green[i], blue[i], alpha[i]},
                             {depth[i], part.number},
                             std::uint16_t(pixel[i]),
                             is_one_sample ? std::uint16_t(1) : masks[i]});
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
    if (marks_) marks_->lay_behind(triangle(f.place.number), f.pixel, colors, samples_);
    lay_over_samples(f.color, f.samples, colors);
    if (samples_ == 1 && s_.on_layer) s_.on_layer(f.pixel, f.place.number, f.color.w);
}

void BlendedLayers::make_room(std::size_t count) {
    if (used_ + count <= m_.waiting.size()) return;
    const std::size_t room = std::max<std::size_t>(used_ + count, 2 * m_.waiting.size());
    job_.front.memory.add(room * waiting_size);  // the old ones live until they are copied
    m_.waiting.resize(room);
    m_.colors.resize(room);
    job_.front.memory.remove(std::exchange(charged_, room * waiting_size));
}

void BlendedLayers::wait(const BatchPart& part) {
    make_room(part.end - part.begin);
    if (samples_ > 1) {
        LayerScratch::Plane& plane = m_.planes[part.number];
        set_plane(triangle(part.number), ox_, oy_, plane);
        plane.reach =
            std::min(plane.depth_high - plane.depth_low, 0.5f * (std::fabs(plane.depth_x) + std::fabs(plane.depth_y)));
    }
    if (++parts_ > most_waiting) return wait_counted(part);
    LayerScratch::Waiting* const waiting = m_.waiting.data();
    vec4* const colors = m_.colors.data();
    std::uint32_t* const last = m_.last.data();
    std::uint16_t* const pixels = m_.pixels.data();
    std::size_t used = used_, count_of_pixels = pixels_;
    for_each_fragment(part, [&](const BlendedFragment& f) {
        const auto at = std::uint32_t(used++);
        const std::uint32_t next = std::exchange(last[f.pixel], at);
        if (next == no_index) pixels[count_of_pixels++] = f.pixel;
        waiting[at] = {f.place, next, f.pixel, f.samples};
        colors[at] = f.color;
    });
    used_ = used, pixels_ = count_of_pixels;
}

/// So many wait that a pixel may have too many.
void BlendedLayers::wait_counted(const BatchPart& part) {
    std::uint16_t* const counts = m_.count.data();
    if (parts_ == most_waiting + 1)
        for (std::size_t i = 0; i < used_; ++i) {
            const LayerScratch::Waiting& w = m_.waiting[i];
            counts[w.pixel] = std::uint16_t(counts[w.pixel] + weight(w.samples));
        }
    for_each_fragment(part, [&](const BlendedFragment& f) {
        std::uint32_t& last = m_.last[f.pixel];
        if (last == no_index) m_.pixels[pixels_++] = f.pixel;
        const auto at = free_ == no_index ? std::uint32_t(used_++) : std::exchange(free_, m_.waiting[free_].next);
        m_.waiting[at] = {f.place, std::exchange(last, at), f.pixel, f.samples};
        m_.colors[at] = f.color;
        counts[f.pixel] = std::uint16_t(counts[f.pixel] + weight(f.samples));
        if (counts[f.pixel] > most_waiting * samples_) lay_early(f);
    });
}

/// The farthest, until not too many wait.
void BlendedLayers::lay_early(const BlendedFragment& added) {
    if (m_.laid.empty()) m_.laid.assign(tile_pixels, {-1, 0});
    LayerPlace& laid = m_.laid[added.pixel];
    if (is_laid_before(added.place, laid)) ++s_.layers_unsorted;
    while (m_.count[added.pixel] > most_waiting * samples_) {
        std::uint32_t* link = &m_.last[added.pixel];
        for (std::uint32_t* next = &m_.waiting[*link].next; *next != no_index; next = &m_.waiting[*next].next)
            if (is_laid_before(m_.waiting[*next].place, m_.waiting[*link].place)) link = next;
        const std::uint32_t at = *link;
        const BlendedFragment farthest = waiting(at);
        *link = std::exchange(m_.waiting[at].next, std::exchange(free_, at));
        if (!is_laid_before(farthest.place, laid)) laid = farthest.place;
        lay(farthest);
        m_.count[added.pixel] = std::uint16_t(m_.count[added.pixel] - weight(farthest.samples));
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
std::span<const SortedLayer> BlendedLayers::sorted(std::size_t pixel, SortedLayer* end) const {
    SortedLayer* begin = end;
    for (std::uint32_t at = m_.last[pixel]; at != no_index; at = m_.waiting[at].next)
        *--begin = {m_.waiting[at].place, at};
    if (is_laid_before(end[-1].place, begin->place)) std::reverse(begin, end);
    for (SortedLayer* last = begin + 1; last < end; ++last) insert_last_layer(begin, last + 1, place_of);
    return {begin, end};
}

void BlendedLayers::finish_plain(std::span<const std::uint16_t> pixels) {
    SortedLayer all[most_together][most_waiting];
    std::span<const SortedLayer> layers[most_together];
    vec4 colors[most_together];
    std::size_t most = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        layers[i] = sorted(pixels[i], std::end(all[i]));
        colors[i] = s_.color[pixels[i]];
        most = std::max(most, layers[i].size());
    }
    for (std::size_t k = 0; k < most; ++k)
        for (std::size_t i = 0; i < pixels.size(); ++i)
            if (k < layers[i].size()) lay_over(m_.colors[layers[i][k].at], colors[i]);
    for (std::size_t i = 0; i < pixels.size(); ++i) s_.color[pixels[i]] = colors[i];
}

void BlendedLayers::finish_pixel(std::size_t pixel) {
    SortedLayer all[most_fragments];
    const std::span<const SortedLayer> layers = sorted(pixel, std::end(all));
    // Marks lie between surfaces on all samples of a pixel.
    const bool is_one_order = samples_ == 1 || (marks_ && marks_->has_any(pixel)) || is_order_of_all_samples(layers);
    if (!is_one_order) return lay_by_samples(layers);
    for (const SortedLayer& layer : layers) lay(waiting(layer.at));
}

/// Farthest first: none comes before another at any sample that both cover.
bool BlendedLayers::is_order_of_all_samples(std::span<const SortedLayer> layers) const {
    const auto nearest = [this](LayerPlace p) { return p.key + m_.planes[p.number].reach; };
    const auto farthest = [this](LayerPlace p) { return p.key - m_.planes[p.number].reach; };
    for (std::size_t i = 1; i < layers.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const SortedLayer &a = layers[k], &b = layers[i];
            if ((m_.waiting[a.at].samples & m_.waiting[b.at].samples) != 0 &&
                !(nearest(a.place) < farthest(b.place) * (1 - 2 * equal_depths)))
                return false;
        }
    return true;
}

void BlendedLayers::lay_by_samples(std::span<const SortedLayer> layers) {
    const auto positions = sample_positions(int(samples_));
    const std::size_t pixel = m_.waiting[layers[0].at].pixel;
    vec4* const colors = sample_colors(pixel);
    for (std::size_t k = 0; k < samples_; ++k) {
        const float x = float(pixel % tile_size) + float(positions[k].x) / 16,
                    y = float(pixel / tile_size) + float(positions[k].y) / 16;
        SortedLayer at_sample[most_fragments];
        SortedLayer* end = at_sample;
        for (const SortedLayer& layer : layers) {
            if (!(m_.waiting[layer.at].samples >> k & 1u)) continue;
            *end++ = {{depth_at(m_.planes[layer.place.number], x, y), layer.place.number}, layer.at};
            insert_last_layer(at_sample, end, place_of);
        }
        for (const SortedLayer* layer = at_sample; layer != end; ++layer) lay_over(m_.colors[layer->at], colors[k]);
    }
}

}  // namespace rakelight::raster
