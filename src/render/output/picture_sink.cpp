// SPDX-License-Identifier: Apache-2.0
#include "render/output/picture_sink.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "base/assert.h"
#include "base/huge_pages.h"
#include "engines/channel_arrays.h"
#include "world/keys/channel_info.h"

namespace rakelight {
namespace {

constexpr std::size_t strip_bytes = std::size_t(64) << 20;
constexpr int strip_granularity = 64;  ///< [rows] no engine's tile is higher

/// As many rows as fit, in whole rows of tiles.
int rows_that_fit(std::size_t row_bytes, int height) {
    const std::size_t fit = strip_bytes / row_bytes / strip_granularity;
    return int(std::min<std::size_t>(std::max<std::size_t>(fit, 1) * strip_granularity, std::size_t(height)));
}

}  // namespace

void PictureSink::begin(int width, int height, Window window, std::uint32_t channels) {
    window_ = window.width == 0 ? Window{0, 0, width, height} : window;
    first_ = window_.y;
    std::size_t pixel_bytes = format_.bytes() + (keeps_linear_ ? sizeof(float) * std::size_t(format_.channels) : 0);
    std::vector<ChannelPlane> planes;
    const auto add = [&](const ChannelInfo& info) {
        const std::size_t number = planes.size();
        planes.push_back({info.channel, info.components(), {}});
        if (number < planes_.size())
            planes.back().words = std::move(planes_[number].words);  // memory of the picture before
        pixel_bytes += sizeof(std::uint32_t) * std::size_t(info.components());
    };
    for (const ChannelInfo& info : all_channels())
        if ((channels & info.channel) && !(hides_depth_ && info.channel == channel_depth)) add(info);
    if (hides_depth_) add(info_of(channel_depth));  // behind those that are seen
    planes_ = std::move(planes);
    rows_ = strip_done_ ? rows_that_fit(pixel_bytes * std::size_t(window_.width), window_.height) : window_.height;
    if (strip_done_ && rows_ < strip_granularity) rows_ = strip_granularity;  // what rows_at_once() may say
    const std::size_t pixels = std::size_t(window_.width) * std::size_t(std::min(rows_, window_.height));
    if (color_.capacity() < pixels * format_.bytes()) {
        color_.reserve(pixels * format_.bytes());
        advise_huge_pages(color_.data(), pixels * format_.bytes());
    }
    color_.resize(pixels * format_.bytes());  // every pixel belongs to a tile
    if (keeps_linear_) linear_.resize(pixels * std::size_t(format_.channels));
    for (ChannelPlane& plane : planes_) plane.words.resize(pixels * std::size_t(plane.components));
    brought_ = 0;
    if (gaps_) empty_strip();
}

void PictureSink::empty_strip() {
    const std::size_t pixels = color_.size() / format_.bytes();
    const std::vector<vec4> row(std::size_t(window_.width), *gaps_);
    const PixelFormat linear{Component::f32, format_.channels};
    for (std::size_t at = 0; at + row.size() <= pixels; at += row.size()) {
        convert_row(row.data(), row.size(), format_, tone_, color_.data() + at * format_.bytes());
        if (keeps_linear_)
            convert_row(row.data(), row.size(), linear, tone_,
                        reinterpret_cast<std::byte*>(linear_.data() + at * std::size_t(format_.channels)));
    }
    ChannelArrays one;
    for (ChannelPlane& plane : planes_)
        for_each_channel(
            [&](std::uint32_t bit, auto& values) {
                if (bit != plane.channel) return;
                values.assign(1, empty_value(bit, values));
                for (std::size_t at = 0; at < plane.words.size(); at += std::size_t(plane.components))
                    std::memcpy(plane.words.data() + at, values.data(), sizeof(values[0]));
            },
            one);
}

PictureRows PictureSink::color_rows(int rows) {
    PictureRows out{format_, window_.x, first_, window_.width, rows, color_.data()};
    for (const ChannelPlane& plane : planes_)
        if (keeps_depth_ && plane.channel == channel_depth)
            out.depth = reinterpret_cast<const float*>(plane.words.data());
    return out;
}

PictureRows PictureSink::linear_rows(int rows) {
    PictureRows out = color_rows(rows);
    out.format.component = Component::f32;
    out.bytes = reinterpret_cast<std::byte*>(linear_.data());
    return out;
}

double PictureSink::done() const {
    const double all = double(window_.width) * window_.height;
    return all > 0 ? std::min(1.0, double(brought_) / all) : 1;
}

void PictureSink::finish_partial() {
    if (!strip_done_) return;
    while (first_ < window_.y + window_.height) rows_done(first_, std::min(rows_, window_.y + window_.height - first_));
}

DisplayRows PictureSink::display_rows(const Window& a) {
    if (!wants_srgb8() || format_.channels != 4) return {};
    RL_ASSERT(is_kept(a), "a tile extends beyond the strip");
    static_assert(std::endian::native == std::endian::little);
    const std::size_t first = at_row(a.y - first_) + std::size_t(a.x - window_.x);
    return {reinterpret_cast<std::uint32_t*>(color_.data() + 4 * first), std::size_t(window_.width)};
}

bool PictureSink::is_kept(const Window& a) const {
    return a.x >= window_.x && a.y >= first_ && a.x + a.width <= window_.x + window_.width &&
           a.y + a.height <= std::min(first_ + rows_, window_.y + window_.height);
}

void PictureSink::count_extremes(const std::byte* row, std::size_t count) {
    if (format_.channels == 4)
        extremes_->add({reinterpret_cast<const std::uint32_t*>(row), count});
    else
        extremes_->add_row(row, count, format_.channels);
}

std::size_t PictureSink::place_of(const Tile& tile, int row) const {
    return at_row(tile.area.y - first_ + row) + std::size_t(tile.area.x - window_.x);
}

void PictureSink::keep_channels(const Tile& tile, int row) {
    const std::size_t count = std::size_t(tile.area.width), from = std::size_t(row) * count, to = place_of(tile, row);
    for (ChannelPlane& plane : planes_)
        for_each_channel(
            [&](std::uint32_t bit, const auto& values) {
                if (bit == plane.channel)
                    std::memcpy(plane.words.data() + to * std::size_t(plane.components), values.data() + from,
                                count * sizeof(values[0]));
            },
            tile);
}

void PictureSink::tile(const Tile& tile) {
    RL_ASSERT(is_kept(tile.area), "a tile extends beyond the strip");
    const std::size_t count = std::size_t(tile.area.width);
    brought_ += count * std::size_t(tile.area.height);
    const PixelFormat linear{Component::f32, format_.channels};
    const bool counts = extremes_ && format_.component == Component::u8;
    for (int row = 0; row < tile.area.height; ++row) {
        const vec4* const color = tile.color.data() + std::size_t(row) * count;
        const std::size_t to = place_of(tile, row);
        std::byte* const out = color_.data() + to * format_.bytes();
        convert_row(color, count, format_, tone_, out);
        if (counts) count_extremes(out, count);
        if (keeps_linear_)
            convert_row(color, count, linear, tone_,
                        reinterpret_cast<std::byte*>(linear_.data() + to * std::size_t(format_.channels)));
        keep_channels(tile, row);
    }
}

void PictureSink::display_tile(const Tile& tile, std::span<const std::uint32_t> srgb8) {
    RL_ASSERT(is_kept(tile.area), "a tile extends beyond the strip");
    const std::size_t count = std::size_t(tile.area.width);
    brought_ += count * std::size_t(tile.area.height);
    if (extremes_) extremes_->add(srgb8);
    for (int row = 0; row < tile.area.height; ++row) {
        std::byte* const out = color_.data() + place_of(tile, row) * format_.bytes();
        if (!srgb8.empty())
            pack_row(srgb8.data() + std::size_t(row) * count, count, format_.channels, out);
        else if (extremes_)
            count_extremes(out, count);
        keep_channels(tile, row);
    }
}

void PictureSink::rows_done(int first, int rows) {
    if (!strip_done_) return;
    RL_ASSERT(first == first_ && rows <= rows_, "strips come in order");
    strip_done_(rows);
    first_ += rows;
    if (gaps_) empty_strip();
}

}  // namespace rakelight
