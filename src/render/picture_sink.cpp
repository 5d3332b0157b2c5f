// SPDX-License-Identifier: Apache-2.0
#include "render/picture_sink.h"

#include <cstring>

#include "base/assert.h"

namespace rakelight {
namespace {

float as_float(std::uint32_t number) { return number == none ? -1.0f : float(number); }

}  // namespace

const char* name_of_channel(std::uint32_t channel) {
    switch (channel) {
        case channel_depth:
            return "depth";
        case channel_normal:
            return "normal";
        case channel_object:
            return "object";
        case channel_material:
            return "material";
    }
    return "channel";
}

int components_of_channel(std::uint32_t channel) { return channel == channel_normal ? 3 : 1; }

void PictureSink::begin(int width, int height, Window window, std::uint32_t channels) {
    window_ = window.width == 0 ? Window{0, 0, width, height} : window;
    const std::size_t pixels = std::size_t(window_.width) * std::size_t(window_.height);
    color_.resize(pixels * format_.bytes());  // every pixel belongs to a tile
    std::size_t used = 0;
    for (std::uint32_t bit = 1; bit != 0 && bit <= channels; bit <<= 1) {
        if (!(channels & bit)) continue;
        if (used == planes_.size()) planes_.emplace_back();
        ChannelPlane& plane = planes_[used++];
        plane.channel = bit;
        plane.components = components_of_channel(bit);
        plane.values.resize(pixels * std::size_t(plane.components));
    }
}

void PictureSink::tile(const Tile& tile) {
    const Window& a = tile.area;
    RL_ASSERT(a.x >= window_.x && a.y >= window_.y && a.x + a.width <= window_.x + window_.width &&
                  a.y + a.height <= window_.y + window_.height,
              "a tile reaches out of the window");
    const std::size_t count = std::size_t(a.width);
    for (int row = 0; row < a.height; ++row) {
        const std::size_t from = std::size_t(row) * count;
        const std::size_t to =
            std::size_t(a.y - window_.y + row) * std::size_t(window_.width) + std::size_t(a.x - window_.x);
        std::byte* const out = color_.data() + to * format_.bytes();
        if (!tile.srgb8.empty())
            pack_row(tile.srgb8.data() + from, count, format_.channels, out);
        else
            convert_row(tile.color.data() + from, count, format_, out);
        for (ChannelPlane& plane : planes_) store(plane, tile, from, to, count);
    }
}

void PictureSink::store(ChannelPlane& plane, const Tile& tile, std::size_t from, std::size_t to,
                        std::size_t count) const {
    float* out = plane.values.data() + to * std::size_t(plane.components);
    switch (plane.channel) {
        case channel_depth:
            std::memcpy(out, tile.depth.data() + from, count * sizeof(float));
            break;
        case channel_normal:
            std::memcpy(out, tile.normal.data() + from, count * sizeof(vec3));
            break;
        case channel_object:
            for (std::size_t i = 0; i < count; ++i) out[i] = as_float(tile.object[from + i]);
            break;
        case channel_material:
            for (std::size_t i = 0; i < count; ++i) out[i] = as_float(tile.material[from + i]);
            break;
    }
}

const float* PictureSink::channel_row(std::size_t plane, int y) const {
    const ChannelPlane& p = planes_[plane];
    return p.values.data() + std::size_t(y) * std::size_t(window_.width) * std::size_t(p.components);
}

}  // namespace rakelight
