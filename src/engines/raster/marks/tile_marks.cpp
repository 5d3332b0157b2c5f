// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/marks/tile_marks.h"

#include <limits>
#include <utility>

#include "engines/channel_arrays.h"
#include "math/linear.h"

namespace rakelight::raster {

TileMarks::TileMarks(const TileJob& job, std::size_t tile, TileScratch& scratch)
    : job_(job),
      marks_(*job.marks),
      s_(scratch),
      area_(job.grid.pixels(tile)),
      paraboloid_(job.front.view, 0.5 * double(job.front.settings.point_size)),
      ox_(job.grid.origin_x(tile)),
      oy_(job.grid.origin_y(tile)),
      blocks_(paraboloid_, 0.5 * double(job.front.settings.point_size), ox_, oy_),
      first_(job.binned.offsets[tile]),
      items_(marks_.items.begin() + marks_.offsets[tile], marks_.items.begin() + marks_.offsets[tile + 1]),
      open_(tile_pixels),
      surfaces_(tile_pixels) {
    close_hidden();
    if (job.front.settings.channels != 0) top_.resize(tile_pixels);
    if (marks_.is_of_one_color) return;
    sort_far_to_near();
}

void TileMarks::sort_far_to_near() {
    std::vector<std::pair<float, std::uint64_t>> by_depth;  // marks lie far apart in memory
    by_depth.reserve(items_.size());
    for (const std::uint64_t item : items_)
        by_depth.emplace_back(marks_.at(item).key[0] + marks_.at(item).key[1], item);
    std::ranges::stable_sort(by_depth, {}, &std::pair<float, std::uint64_t>::first);
    for (std::size_t i = 0; i < items_.size(); ++i) items_[i] = by_depth[i].second;
}

/// Pixels outside of the window, and those where even the nearest mark is hidden.
void TileMarks::close_hidden() {
    float nearest = 0, width = 0;
    for (const std::uint64_t item : items_) {
        const Mark& m = marks_.at(item);
        nearest = std::max({nearest, m.key[0], m.key[1]});
        width = std::max(width, size_of(m));
    }
    for (int y = 0; y < tile_size; ++y)
        for (int x = 0; x < tile_size; ++x) {
            const auto p = std::size_t(y * tile_size + x);
            const bool is_inside = x + ox_ >= area_.x && x + ox_ < area_.x + area_.width && y + oy_ >= area_.y &&
                                   y + oy_ < area_.y + area_.height;
            if (!is_inside || is_hidden(p, double(nearest), mark_reach(width))) open_.close(p);
        }
}

/// Between the ends' own colors, as attributes of triangles are: part / w is affine on the screen.
vec4 TileMarks::mixed_color(const Mark& m, double key, double t) const {
    const vec4 a = marks_.colors[m.color[0]], b = marks_.colors[m.color[1]];
    const bool is_flat = job_.front.view.orthographic || !(key > 0);
    const double ka = is_flat ? 1 : double(m.key[0]), kb = is_flat ? 1 : double(m.key[1]);
    const double part = (double(m.part[0]) * ka * (1 - t) + double(m.part[1]) * kb * t) / (ka * (1 - t) + kb * t);
    return a + (b - a) * float(part);
}

/// From near to far, so that most of many points in one place are found to be hidden. Channels hold the first of equal
/// ones, so all are looked at for them.
void TileMarks::find_nearest() {
    nearest_.assign(tile_pixels, std::numeric_limits<float>::lowest());
    const bool has_surfaces = std::ranges::any_of(s_.visible, [](std::int32_t v) { return v >= 0; });
    const bool can_cover_blocks = job_.front.settings.point_size >= PointBlocks::side;
    if (top_.empty() && can_cover_blocks) shown_.assign(items_.size(), ~PointBlocks::Mask(0));
    for (std::size_t i = items_.size(); i-- > 0;) {
        const Mark& m = marks_.at(items_[i]);
        if (job_.is_cancelled() || m.shape == Mark::Shape::line) continue;
        const MarkShape shape = shape_of(m);
        if (!shown_.empty()) shown_[i] = blocks_.shown(m, shape.reach());
        if (!is_opaque(m)) continue;
        for_each_window(i, [&](const Window& window) { fill(m, shape, window); });
        if (!shown_.empty() && shown_[i] != 0 && !has_surfaces) blocks_.add(m, shape);
    }
}

void TileMarks::fill(const Mark& m, const MarkShape& shape, const Window& window) {
    int filled = 0;
    for_each_pixel(m, shape, window, [&](std::uint32_t p, const MarkShape::Near& near, double key) {
        if (!shape.fills(near)) return;
        nearest_[p] = std::max(nearest_[p], order_of(m, shape, near, key));
        ++filled;
    });
    if (filled == PointBlocks::side * PointBlocks::side && window.width == PointBlocks::side)
        blocks_.add(((window.y - oy_) * PointBlocks::across + window.x - ox_) / PointBlocks::side, m);
}

void TileMarks::show(std::uint32_t pixel, const Mark& m, const TopMark& here) {
    TopMark& top = top_[pixel];
    if (is_opaque(m) && (top.key < 0 || here.order > top.order)) top = here;
}

void TileMarks::put_channels() {
    for (std::size_t p = 0; p < top_.size(); ++p)
        if (top_[p].key >= 0) put(p, top_[p]);
}

const Draw* TileMarks::draw_at(std::size_t pixel) {
    top_.assign(tile_pixels, TopMark{});
    for_each_fragment([](const MarkFragment&) { return false; });
    return top_[pixel].key < 0 ? nullptr : marks_.draws[top_[pixel].item >> 32];
}

/// A mark has no triangle, normal or texture coordinates, and is not lit: these channels have their background values.
void TileMarks::put(std::size_t pixel, const TopMark& top) {
    const std::uint32_t channels = job_.front.settings.channels;
    for_each_channel(
        [&](std::uint32_t bit, auto& array) {
            if ((channels & bit) && bit != channel_overdraw) array[pixel] = empty_value(bit, array);
        },
        static_cast<ChannelArrays&>(s_));
    const Draw& draw = *marks_.draws[top.item >> 32];
    const Mark& m = marks_.at(top.item);
    const vec3 color = color_at(m, double(top.key), double(top.t)).xyz();
    s_.depth[pixel] = top.key;
    if (channels & channel_object) s_.object[pixel] = draw.node;
    if (channels & channel_mesh) s_.mesh[pixel] = draw.mesh;
    if (channels & channel_material) s_.material[pixel] = job_.front.list.materials[draw.material].scene_material;
    if (channels & channel_base_color) s_.base_color[pixel] = color;
    if (channels & channel_emission) s_.emission[pixel] = color;
    if (!(channels & channel_position)) return;
    const int x = ox_ + int(pixel) % tile_size, y = oy_ + int(pixel) / tile_size;
    s_.position[pixel] = cast<float>(job_.front.view.place(x + 0.5, y + 0.5, double(top.key)));
}

}  // namespace rakelight::raster
