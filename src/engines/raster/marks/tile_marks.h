// SPDX-License-Identifier: Apache-2.0
// The lines and points of one tile, pixel by pixel: what they cover and no surface hides, and which of them the data
// channels hold.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "base/open_places.h"
#include "engines/raster/marks/mark_coverage.h"
#include "engines/raster/marks/point_blocks.h"
#include "engines/raster/tile.h"
#include "engines/raster/visibility/coverage.h"

namespace rakelight::raster {

/// How much farther than a surface a mark on it may seem.
struct DepthTolerance {
    double slope = 0, range = -1;  ///< of its depth keys, per px; -1: not known yet

    /// The change over `reach` px, at most the surface's whole depth, and what rounding makes.
    double of(double key, double reach) const { return std::min(range, slope * reach) + 4e-6 * std::fabs(key); }
};

/// The plane of a surface's depth keys about the tile's first pixel.
class SurfacePlane {
public:
    SurfacePlane() = default;
    SurfacePlane(const ScreenTriangle& s, int tile_x, int tile_y) { set_depth(s, tile_x, tile_y, c_); }

    /// @param pixel  of the tile
    double key(std::size_t pixel) const {
        const std::size_t column = pixel % tile_size, row = pixel / tile_size;
        const double plane =
            double(c_.depth_0) + double(c_.depth_x) * double(column) + double(c_.depth_y) * double(row);
        const double from_below = plane > double(c_.depth_low) ? plane : double(c_.depth_low);  // NaN: the farthest
        return std::min(from_below, double(c_.depth_high));
    }
    DepthTolerance tolerance() const {
        return {std::fabs(double(c_.depth_x)) + std::fabs(double(c_.depth_y)),
                double(c_.depth_high) - double(c_.depth_low)};
    }

private:
    KeyPlane c_{};
};

class TileMarks {
public:
    TileMarks(const TileJob& job, std::size_t tile, TileScratch& scratch);

    /// Calls take(MarkFragment) for what no opaque surface hides, mark by mark: in the order of the scene, or far to
    /// near where colors differ. Of the opaque points that cover a whole pixel it shows one.
    /// @param take  returns whether fragments of the same color cannot change the pixel any more: with one color, no
    ///              more of them are made there
    template <class Take>
    void for_each_fragment(const Take& take) {
        if (!marks_.is_of_one_color) find_nearest();
        for (std::size_t i = 0; i < items_.size(); ++i) {
            if (job_.is_cancelled()) return;
            for_each_window(i, [&](const Window& window) { draw(items_[i], marks_.at(items_[i]), window, take); });
        }
    }
    /// Where the center of a pixel lies in an opaque mark, the channels hold the nearest such mark. After everything
    /// that compares depths.
    void put_channels();
    std::uint64_t tests() const { return tests_; }  ///< of a pixel against a mark so far
    /// Whose mark they hold at a pixel of the tile; null: none's.
    const Draw* draw_at(std::size_t pixel);

private:
    /// What the channels of a pixel hold.
    struct TopMark {
        float key = -1;   ///< -1: no mark
        float order = 0;  ///< order_of()
        float t;          ///< along the mark
        std::uint64_t item;
    };

    float size_of(const Mark& m) const {
        return m.shape == Mark::Shape::line ? job_.front.settings.line_width : job_.front.settings.point_size;
    }
    MarkShape shape_of(const Mark& m) const { return {m, size_of(m)}; }
    bool is_opaque(const Mark& m) const { return marks_.colors[m.color[0]].w >= 1 && marks_.colors[m.color[1]].w >= 1; }
    /// By which marks hide each other: the nearer one has more.
    float order_of(const Mark& m, const MarkShape& shape, const MarkShape::Near& near, double key) const {
        return float(m.shape == Mark::Shape::line ? key : paraboloid_.key(key, shape.sunk(near)));
    }

    /// From `y` on.
    int first_open_row(int y) { return oy_ + int(open_.from(std::size_t(y - oy_) * tile_size)) / tile_size; }
    void sort_far_to_near();
    void close_hidden();
    /// The parts of the tile where an item may be shown.
    template <class Run>
    void for_each_window(std::size_t item, const Run& run) const {
        if (shown_.empty()) return run(area_);
        for (PointBlocks::Mask left = shown_[item]; left != 0; left &= left - 1)
            run(blocks_.window(std::countr_zero(left)));
    }
    /// Calls run(pixel, near, key) where the mark may cover something and no opaque surface hides it.
    template <class Run>
    void for_each_pixel(const Mark& m, const MarkShape& shape, const Window& window, const Run& run) {
        const auto [top, bottom] = shape.rows(window);
        for (int y = top; y <= bottom; ++y) {
            if (const int open = first_open_row(y); open != y) {
                y = open - 1;
                continue;
            }
            const auto [left, right] = shape.columns(y, window);
            const int row = (y - oy_) * tile_size - ox_, end = row + right;
            for (auto p = int(open_.from(std::size_t(row + left))); p <= end; p = int(open_.from(std::size_t(p) + 1))) {
                ++tests_;
                const MarkShape::Near near = shape.nearest(p - row, y);
                if (shape.is_out_of_reach(near)) continue;
                const double key = double(m.key[0]) + (double(m.key[1]) - double(m.key[0])) * near.t;
                if (!is_hidden(std::size_t(p), key, shape.reach())) run(std::uint32_t(p), near, key);
            }
        }
    }

    template <class Take>
    void draw(std::uint64_t item, const Mark& m, const Window& window, const Take& take) {
        const MarkShape shape = shape_of(m);
        const std::uint32_t color = m.color[0] == m.color[1] ? m.color[0] : no_index;
        for_each_pixel(m, shape, window, [&](std::uint32_t p, const MarkShape::Near& near, double key) {
            const double covered = shape.coverage(near);
            if (!(covered > 1e-6)) return;
            const float order = order_of(m, shape, near, key);
            if (!top_.empty() && shape.has_center(near)) show(p, m, {float(key), order, float(near.t), item});
            if (!nearest_.empty() && m.shape != Mark::Shape::line && order < nearest_[p]) return;
            const bool is_whole = take(MarkFragment{p, color, float(key), float(covered), float(shape.reach()),
                                                    color_at(m, key, near.t), &m, marks_.draws[item >> 32]});
            if (is_whole && marks_.colors.size() == 1 && top_.empty()) open_.close(p);
        });
    }

    bool is_hidden(std::size_t p, double key, double reach) {
        const double depth = double(s_.depth[p]);
        if (key >= depth || s_.visible[p] < 0) return false;
        DepthTolerance& surface = surfaces_[p];
        if (surface.range < 0)
            surface = SurfacePlane(*job_.binned.items[first_ + std::uint32_t(s_.visible[p])], ox_, oy_).tolerance();
        return key + surface.of(key, reach) < depth;
    }

    vec4 color_at(const Mark& m, double key, double t) const {
        return m.color[0] == m.color[1] ? marks_.colors[m.color[0]] : mixed_color(m, key, t);
    }
    vec4 mixed_color(const Mark& m, double key, double t) const;
    void find_nearest();
    void fill(const Mark& m, const MarkShape& shape, const Window& window);
    void show(std::uint32_t pixel, const Mark& m, const TopMark& here);
    void put(std::size_t pixel, const TopMark& top);

    const TileJob& job_;
    const Marks& marks_;
    TileScratch& s_;
    Window area_;
    PointParaboloid paraboloid_;
    int ox_, oy_;
    PointBlocks blocks_;
    std::uint32_t first_;
    std::vector<std::uint64_t> items_;
    std::vector<TopMark> top_;    ///< [tile_pixels] where channels are requested
    std::vector<float> nearest_;  ///< [tile_pixels] order of the opaque point that fills the pixel; empty: unknown
    std::vector<PointBlocks::Mask> shown_;  ///< [items_] where others do not hide them; empty: unknown
    OpenPlaces open_;                       ///< [tile_pixels] closed: no mark changes the pixel any more
    std::uint64_t tests_ = 0;
    std::vector<DepthTolerance> surfaces_;  ///< [tile_pixels] what is seen there, where it was requested
};

}  // namespace rakelight::raster
