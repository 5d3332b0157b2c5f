// SPDX-License-Identifier: Apache-2.0
// Frame: the sink that keeps everything of a window.
#include <rakelight/base/error.h>
#include <rakelight/engines/engine.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <new>
#include <string>

#include "base/format_text.h"
#include "engines/channel_arrays.h"

namespace rakelight {
namespace {

/// Copies the rows of a tile into the array of the window; arrays that the engine did not fill stay as they are.
template <class T>
void copy_rows(std::span<const T> from, const Window& area, std::vector<T>& to, const Window& window) {
    if (from.empty() || to.empty()) return;
    const std::size_t width = std::size_t(area.width);
    if (from.size() != width * std::size_t(area.height))
        throw Error(ErrorCode::usage, format_text("an array of a tile has {} entries for {} x {} pixels", from.size(),
                                                  area.width, area.height));
    for (int row = 0; row < area.height; ++row) {
        const std::size_t at =
            std::size_t(area.y - window.y + row) * std::size_t(window.width) + std::size_t(area.x - window.x);
        std::copy_n(from.begin() + std::ptrdiff_t(std::size_t(row) * width), width, to.begin() + std::ptrdiff_t(at));
    }
}

/// Along one axis; without sums that may overflow.
bool is_inside(int from, int length, int outer_from, int outer_length) {
    return length >= 0 && from >= outer_from && std::int64_t(from) + length <= std::int64_t(outer_from) + outer_length;
}

/// What the arrays take [bytes]; double, since sizes from anywhere may be multiplied.
double size_of(const Window& window, std::uint32_t channels) {
    double per_pixel = sizeof(vec4);
    const ChannelArrays arrays;
    for_each_channel(
        [&]<class T>(std::uint32_t bit, const std::vector<T>&) { per_pixel += channels & bit ? sizeof(T) : 0; },
        arrays);
    return double(window.width) * double(window.height) * per_pixel;
}

/// [bytes] All of it; infinite where the system does not say.
double memory_of_machine() {
    const long pages = ::sysconf(_SC_PHYS_PAGES), size = ::sysconf(_SC_PAGE_SIZE);
    return pages > 0 && size > 0 ? double(pages) * double(size) : std::numeric_limits<double>::infinity();
}

Error too_large(const Window& window, double bytes) {
    constexpr double mib = 1 << 20;
    return Error(ErrorCode::failed,
                 format_text("a frame of {} x {} pixels needs {} MiB, more than available", window.width, window.height,
                             std::uint64_t(std::min(bytes / mib, 1e18))),
                 {}, "render a smaller window, fewer channels, or into a sink that takes rows");
}

}  // namespace

void Frame::begin(int picture_width, int picture_height, Window picture_window, std::uint32_t channels) {
    if (picture_width < 0 || picture_height < 0 || picture_window.width < 0 || picture_window.height < 0)
        throw Error(ErrorCode::usage, "a picture or window has a size below 0");
    width = picture_width;
    height = picture_height;
    window = picture_window.width == 0 ? Window{0, 0, width, height} : picture_window;
    const std::size_t pixels = std::size_t(window.width) * std::size_t(window.height);
    const double bytes = size_of(window, channels);
    if (bytes > memory_of_machine()) throw too_large(window, bytes);  // first: what is promised may not be there
    try {
        color.assign(pixels, vec4{0, 0, 0, 0});
        clear(*this, channels, pixels);
    } catch (const std::bad_alloc&) {
        throw too_large(window, bytes);
    }
}

void Frame::tile(const Tile& tile) {
    const Window& a = tile.area;
    if (!is_inside(a.x, a.width, window.x, window.width) || !is_inside(a.y, a.height, window.y, window.height))
        throw Error(ErrorCode::usage, "a tile extends beyond the window");
    copy_rows(tile.color, a, color, window);
    for_each_channel([&](std::uint32_t, const auto& from, auto& to) { copy_rows(from, a, to, window); }, tile,
                     static_cast<ChannelArrays&>(*this));
}

void Frame::end_pass(int) {}

}  // namespace rakelight
