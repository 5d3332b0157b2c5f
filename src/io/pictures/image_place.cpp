// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/image_place.h"

#include <array>
#include <charconv>

#include "base/format_text.h"

namespace rakelight::io {
namespace {

constexpr std::string_view between = " of ";

/// "1,2,3": as many numbers as there is room for, and nothing else.
template <std::size_t count>
bool read_numbers(std::string_view text, std::array<int, count>& numbers) {
    const char *at = text.data(), *const end = at + text.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0 && (at == end || *at++ != ',')) return false;
        const auto [next, fault] = std::from_chars(at, end, numbers[i]);
        if (fault != std::errc() || numbers[i] < 0) return false;
        at = next;
    }
    return at == end;
}

}  // namespace

std::string window_text(const ImagePlace& place, int width, int height) {
    if (place.width == 0 || place == ImagePlace{0, 0, width, height}) return {};
    const auto list = [](int a, int b) { return format_text("{},{}", a, b); };
    return list(place.x, place.y) + "," + list(width, height) + std::string(between) + list(place.width, place.height);
}

ImagePlace place_of(std::string_view text, int width, int height) {
    const std::size_t middle = text.find(between);
    std::array<int, 4> window{};
    std::array<int, 2> whole{};
    if (middle == std::string_view::npos || !read_numbers(text.substr(0, middle), window) ||
        !read_numbers(text.substr(middle + between.size()), whole))
        throw Error(ErrorCode::bad_file,
                    "its metadata name the window '" + one_line(std::string(text), 60) + "', which is not valid");
    if (window[2] != width || window[3] != height)
        throw Error(ErrorCode::bad_file, format_text("its metadata name a window of {} x {} pixels, but it has {} x {}",
                                                     window[2], window[3], width, height));
    return {window[0], window[1], whole[0], whole[1]};
}

}  // namespace rakelight::io
