// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/shade/blend_tile.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "engines/raster/marks/mark_layers.h"
#include "engines/raster/material_jobs.h"
#include "engines/raster/multisample.h"
#include "engines/raster/shade/blend_groups.h"
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

Window common(const Window& a, const Window& b) {
    const int left = std::max(a.x, b.x), top = std::max(a.y, b.y);
    return {left, top, std::min(a.x + a.width, b.x + b.width) - left, std::min(a.y + a.height, b.y + b.height) - top};
}

class BlendedTile {
public:
    BlendedTile(const TileJob& job, std::size_t tile, const std::vector<std::uint32_t>& order, MarkLayers* marks,
                int samples, TileScratch& scratch)
        : job_(job),
          s_(scratch),
          m_(*scratch.layers),
          tile_(tile),
          by_pixel_(marks && samples > 1),
          order_(order),
          area_(job.grid.pixels(tile)),
          first_(job.binned.offsets[tile]),
          ox_(job.grid.origin_x(tile)),
          oy_(job.grid.origin_y(tile)),
          samples_(samples),
          layers_(job, tile, scratch, marks, samples) {}

    /// Where something must wait, by quarters: less waits at a time, and what crosses elsewhere need not.
    void lay() {
        const std::vector<GroupedTriangle> all =
            blend_groups(job_, tile_, {ox_, oy_, tile_size, tile_size}, order_, by_pixel_);
        if (std::none_of(all.begin(), all.end(), [](const GroupedTriangle& t) { return t.waits; })) return lay(all);
        constexpr int half = tile_size / 2;
        const Window whole = area_;
        for (int k = 0; k < 4; ++k) {
            const Window quarter{ox_ + k % 2 * half, oy_ + k / 2 * half, half, half};
            area_ = common(whole, quarter);
            std::vector<std::uint32_t> order;
            std::copy_if(order_.begin(), order_.end(), std::back_inserter(order),
                         [&](std::uint32_t item) { return box_pixels(*job_.binned.items[item], quarter) > 0; });
            if (area_.width > 0 && area_.height > 0) lay(blend_groups(job_, tile_, quarter, order, by_pixel_));
        }
    }

private:
    struct Part {
        GroupedTriangle triangle;
        BatchPart pixels;
    };

    void lay(const std::vector<GroupedTriangle>& triangles) {
        group_ = 0;
        for (const GroupedTriangle& t : triangles) {
            if (job_.is_cancelled()) return;
            add(t, *job_.binned.items[first_ + t.number]);
        }
        shade();
        layers_.finish();
    }

    void add(const GroupedTriangle& grouped, const ScreenTriangle& t) {
        const std::size_t most = box_pixels(t, area_);
        if (most == 0) return;
        if (!s_.wanted.empty() &&
            (s_.wanted[0]->draw != t.draw || count_ + most > tile_pixels || s_.wanted.size() == most_triangles))
            shade();
        BatchPart part{grouped.number, count_, count_};
        if (samples_ > 1)
            collect_samples(t);
        else
            collect(t, std::int32_t(grouped.number));
        part.end = count_;
        if (part.begin == part.end) return;
        if (samples_ > 1 && grouped.waits) find_depths(t, part);
        std::fill(s_.batch_triangle.begin() + std::ptrdiff_t(part.begin),
                  s_.batch_triangle.begin() + std::ptrdiff_t(part.end), std::int32_t(s_.wanted.size()));
        s_.wanted.push_back(&t);
        parts_.push_back({grouped, part});
    }

    void collect(const ScreenTriangle& t, std::int32_t position) {
        const BlendTest is_before(job_.front, t, position);
        const int ox = ox_, oy = oy_;
        const TileScratch& s = s_;
        std::size_t count = count_;
        std::int32_t* const pixel = s_.pixel.data();
        float* const depths = s_.batch_depth.data();
        cover(t, area_, ox, oy, [&](int x, int y, float depth) {
            if (!is_before(x, y, ox, oy, depth, s)) return;
            pixel[count] = y * tile_size + x;
            depths[count++] = depth;
        });
        count_ = count;
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
        for (std::size_t i = before; i < count_; ++i) {
            m_.batch_masks[i] = std::exchange(m_.masks[std::size_t(s_.pixel[i])], std::uint16_t(0));
            move_to_middle(samples_, m_.batch_masks[i], i, s_);
        }
    }

    /// At the pixels' centers, also where the triangle covers other samples alone.
    void find_depths(const ScreenTriangle& t, const BatchPart& part) {
        KeyPlane plane;
        set_plane(t, ox_, oy_, plane);
        for (std::size_t i = part.begin; i < part.end; ++i)
            s_.batch_depth[i] = depth_at(plane, float(s_.pixel[i] % tile_size), float(s_.pixel[i] / tile_size));
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
            give_parts();
        }
        count_ = 0;
        s_.wanted.clear();
        parts_.clear();
    }

    void give_parts() {
        for (const Part& p : parts_) {
            if (p.triangle.group != group_) layers_.finish();
            group_ = p.triangle.group;
            p.triangle.waits ? layers_.wait(p.pixels) : layers_.lay(p.pixels);
        }
    }

    const TileJob& job_;
    TileScratch& s_;
    LayerScratch& m_;
    const std::size_t tile_;
    const bool by_pixel_;
    const std::vector<std::uint32_t>& order_;
    Window area_;
    const std::uint32_t first_;
    const int ox_, oy_, samples_;
    BlendedLayers layers_;
    std::vector<Part> parts_;  ///< of the batch
    std::uint32_t group_ = 0;  ///< that came last
    std::size_t count_ = 0;    ///< pixels of the batch
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
