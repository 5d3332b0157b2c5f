// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/shade/blend_tile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engines/raster/marks/mark_layers.h"
#include "engines/raster/material_jobs.h"
#include "engines/raster/multisample.h"
#include "engines/raster/shade/blended_layers.h"
#include "engines/raster/visibility/coverage.h"
#include "engines/raster/visibility/visibility_methods.h"

namespace rakelight::raster {
namespace {

constexpr std::size_t most_triangles = 256;  ///< of a batch

/// The pixels that a triangle may cover, or a sample of theirs.
std::size_t box_pixels(const ScreenTriangle& t, const Window& area) {
    const auto [x_low, x_high] = std::minmax({t.x0, t.x1, t.x2});
    const auto [y_low, y_high] = std::minmax({t.y0, t.y1, t.y2});
    const int left = std::max(x_low >> subpixel_bits, area.x), top = std::max(y_low >> subpixel_bits, area.y);
    const int right = std::min(x_high >> subpixel_bits, area.x + area.width - 1),
              bottom = std::min(y_high >> subpixel_bits, area.y + area.height - 1);
    return left > right || top > bottom ? 0 : std::size_t(right - left + 1) * std::size_t(bottom - top + 1);
}

class BlendedTile {
public:
    BlendedTile(const TileJob& job, std::size_t tile, const std::vector<std::uint32_t>& order, MarkLayers* marks,
                int samples, TileScratch& scratch)
        : job_(job),
          s_(scratch),
          m_(*scratch.layers),
          order_(order),
          area_(job.grid.pixels(tile)),
          first_(job.binned.offsets[tile]),
          ox_(job.grid.origin_x(tile)),
          oy_(job.grid.origin_y(tile)),
          samples_(samples),
          layers_(job, tile, scratch, marks, samples) {
        sort_in_tile();
    }

    void lay() {
        for (std::size_t i = 0; i < order_.size(); ++i) {
            if (job_.is_cancelled()) return;
            add(i, *job_.binned.items[order_[i]]);
        }
        shade();
        layers_.finish();
    }

private:
    /// What the depth keys of a triangle's plane are in the tile.
    struct Range {
        float farthest, nearest;
        std::uint32_t item;
    };
    Range range_of(std::uint32_t item) const {
        Coverage c;
        set_plane(*job_.binned.items[item], ox_, oy_, c);
        constexpr float low = -0.5f, high = tile_size - 0.5f;
        const float keys[] = {depth_at(c, low, low), depth_at(c, high, low), depth_at(c, low, high),
                              depth_at(c, high, high)};
        const auto [farthest, nearest] = std::minmax_element(std::begin(keys), std::end(keys));
        return {*farthest, *nearest, item};
    }

    /// Far to near in this tile, so that little must wait; and the least depth key of what comes after each triangle.
    void sort_in_tile() {
        floors_.assign(order_.size(), std::numeric_limits<float>::infinity());
        if (!has_depth(job_.front.settings.visibility)) return;
        std::vector<Range> ranges;
        for (const std::uint32_t item : order_) ranges.push_back(range_of(item));
        std::stable_sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) {
            return a.farthest + a.nearest < b.farthest + b.nearest;
        });
        for (std::size_t i = 0; i < ranges.size(); ++i) order_[i] = ranges[i].item;
        for (std::size_t i = ranges.size(); i-- > 1;) floors_[i - 1] = std::min(floors_[i], ranges[i].farthest);
    }

    void add(std::size_t place, const ScreenTriangle& t) {
        const std::size_t most = box_pixels(t, area_);
        if (most == 0) return;
        if (!s_.wanted.empty() &&
            (s_.wanted[0]->draw != t.draw || count_ + most > tile_pixels || s_.wanted.size() == most_triangles))
            shade();
        const std::size_t before = count_;
        if (samples_ > 1)
            collect_samples(t);
        else
            collect(t, std::int32_t(order_[place] - first_));
        if (count_ == before) return;
        std::fill(s_.batch_triangle.begin() + std::ptrdiff_t(before),
                  s_.batch_triangle.begin() + std::ptrdiff_t(count_), std::int32_t(s_.wanted.size()));
        s_.wanted.push_back(&t);
        places_.push_back(place);
    }

    void collect(const ScreenTriangle& t, std::int32_t position) {
        const BlendTest is_before(job_.front, t, position);
        cover(t, area_, ox_, oy_, [&](int x, int y, float depth) {
            if (!is_before(x, y, ox_, oy_, depth, s_)) return;
            s_.pixel[count_] = y * tile_size + x;
            s_.batch_depth[count_++] = depth;
        });
    }

    /// Shaded once per pixel, for those of its samples where it is nearest. At an edge that two triangles share, no
    /// sample gets both, so the surface has no seam.
    void collect_samples(const ScreenTriangle& t) {
        const auto positions = sample_positions(samples_);
        const std::size_t before = count_;
        for (std::size_t k = 0; k < positions.size(); ++k)
            cover(seen_from(positions[k], t), area_, ox_, oy_, [&](int x, int y, float depth) {
                const auto p = std::size_t(y * tile_size + x);
                if (!(depth > s_.samples->depth[k * tile_pixels + p])) return;
                if (m_.masks[p] == 0) s_.pixel[count_++] = std::int32_t(p);
                m_.masks[p] = std::uint16_t(m_.masks[p] | 1u << k);
            });
        if (count_ == before) return;
        Coverage plane;
        set_plane(t, ox_, oy_, plane);
        const float reach =
            std::min(plane.depth_high - plane.depth_low, 0.5f * (std::fabs(plane.depth_x) + std::fabs(plane.depth_y)));
        for (std::size_t i = before; i < count_; ++i) {
            const auto p = std::size_t(s_.pixel[i]);
            m_.batch_masks[i] = std::exchange(m_.masks[p], std::uint16_t(0));
            m_.batch_reach[i] = reach;
            s_.batch_depth[i] = depth_at(plane, float(p % tile_size), float(p / tile_size));
            move_to_middle(samples_, m_.batch_masks[i], i, s_);
        }
    }

    /// What was collected, into the layers.
    void shade() {
        if (count_ > 0) {
            const std::uint32_t draw = s_.wanted[0]->draw;
            make_records(job_, draw, s_.wanted, ox_, oy_, s_);
            ShadeJob batch = make_job(job_, draw, ox_, oy_, count_, s_);
            if (samples_ > 1) use_offsets(batch, s_);
            s_.not_finite += std::uint64_t(shade_with_lists(job_.kernels, job_.reach, batch, s_));
            s_.shaded += count_;
            if (!batch.unlit && !batch.lit) s_.lit_pixels += count_;
            for (std::size_t i = 0; i < count_; ++i) add_fragment(i);
        }
        count_ = 0;
        s_.wanted.clear();
        places_.clear();
    }

    void add_fragment(std::size_t i) {
        const bool is_finite = s_.alpha[i] - s_.alpha[i] == 0;
        if (!is_finite) ++s_.not_finite;
        const vec4 color = {s_.red[i], s_.green[i], s_.blue[i], is_finite ? std::clamp(s_.alpha[i], 0.0f, 1.0f) : 0.0f};
        const std::size_t place = places_[std::size_t(s_.batch_triangle[i])];
        const bool is_sampled = samples_ > 1;
        layers_.add({color, s_.batch_depth[i], is_sampled ? m_.batch_reach[i] : 0.0f, order_[place] - first_,
                     std::uint16_t(s_.pixel[i]), is_sampled ? m_.batch_masks[i] : std::uint16_t(1)},
                    floors_[place]);
    }

    const TileJob& job_;
    TileScratch& s_;
    LayerScratch& m_;
    std::vector<std::uint32_t> order_;
    const Window area_;
    const std::uint32_t first_;
    const int ox_, oy_, samples_;
    BlendedLayers layers_;
    std::vector<float> floors_;        ///< beside order_
    std::vector<std::size_t> places_;  ///< in order_, of the batch's triangles
    std::size_t count_ = 0;            ///< pixels of the batch
};

}  // namespace

std::vector<std::uint32_t> blending_order(const TileJob& job, std::size_t tile) {
    struct Layer {
        double place;
        std::uint32_t item;
    };
    std::vector<Layer> layers;
    for (std::uint32_t i = job.binned.offsets[tile]; i < job.binned.offsets[tile + 1]; ++i) {
        const ScreenTriangle& t = *job.binned.items[i];
        if (job.front.list.view(t.draw).blend) layers.push_back({blending_place(job.front, t), i});
    }
    std::stable_sort(layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.place < b.place; });
    std::vector<std::uint32_t> items;
    for (const Layer& layer : layers) items.push_back(layer.item);
    return items;
}

void lay_blended(const TileJob& job, std::size_t tile, const std::vector<std::uint32_t>& order, MarkLayers* marks,
                 int samples, TileScratch& s) {
    if (!s.layers) s.layers = std::make_shared<LayerScratch>();
    s.wanted.clear();
    BlendedTile(job, tile, order, marks, samples, s).lay();
}

void blend_transparent(const TileJob& job, std::size_t tile, TileScratch& s) {
    std::vector<std::uint32_t> order;
    if (job.has_blended) order = blending_order(job, tile);
    if (order.empty()) {
        if (has_marks(job, tile)) draw_marks(job, tile, s);
    } else if (has_marks(job, tile)) {
        MarkLayers marks(job, tile, s);
        lay_blended(job, tile, order, &marks, 1, s);
        marks.lay_rest();
    } else {
        lay_blended(job, tile, order, nullptr, 1, s);
    }
    if (job.to_srgb8) encode_tile(s);
}

}  // namespace rakelight::raster
