// SPDX-License-Identifier: Apache-2.0
// Frame: the sink that keeps everything of a window.
#include <rakelight/engine.h>

#include <algorithm>

#include "base/assert.h"
#include "engines/channel_arrays.h"

namespace rakelight {
namespace {

/// Copies the rows of a tile into the array of the window; arrays that the engine did not fill stay as they are.
template <class T>
void copy_rows(std::span<const T> from, const Window& area, std::vector<T>& to, const Window& window) {
    if (from.empty() || to.empty()) return;
    const std::size_t width = std::size_t(area.width);
    RL_ASSERT(from.size() == width * std::size_t(area.height), "an array of a tile has not its area's size");
    for (int row = 0; row < area.height; ++row) {
        const std::size_t at =
            std::size_t(area.y - window.y + row) * std::size_t(window.width) + std::size_t(area.x - window.x);
        std::copy_n(from.begin() + std::ptrdiff_t(std::size_t(row) * width), width, to.begin() + std::ptrdiff_t(at));
    }
}

}  // namespace

void Frame::begin(int picture_width, int picture_height, Window picture_window, std::uint32_t channels) {
    width = picture_width;
    height = picture_height;
    window = picture_window.width == 0 ? Window{0, 0, width, height} : picture_window;
    const std::size_t pixels = std::size_t(window.width) * std::size_t(window.height);
    color.assign(pixels, vec4{0, 0, 0, 0});
    clear(*this, channels, pixels);
}

void Frame::tile(const Tile& tile) {
    const Window& a = tile.area;
    RL_ASSERT(a.x >= window.x && a.y >= window.y && a.x + a.width <= window.x + window.width &&
                  a.y + a.height <= window.y + window.height,
              "a tile reaches out of the window");
    copy_rows(tile.color, a, color, window);
    for_each_channel([&](std::uint32_t, const auto& from, auto& to) { copy_rows(from, a, to, window); }, tile,
                     static_cast<ChannelArrays&>(*this));
}

void Frame::end_pass(int) {}

}  // namespace rakelight
