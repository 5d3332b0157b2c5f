// SPDX-License-Identifier: Apache-2.0
// What the tests of pictures share: pictures made from a formula.
#pragma once
#include <rakelight/image/image.h>

#include <cstring>
#include <vector>

namespace rakelight::test {

/// A picture whose component c of pixel (x, y) is value(x, y, c).
template <class T, class Value>
Pixels picture_of(int width, int height, int channels, const Value& value) {
    constexpr Component component = sizeof(T) == 1 ? Component::u8 : sizeof(T) == 2 ? Component::u16 : Component::f32;
    Pixels pixels{width, height, channels, component, component == Component::f32, {}};
    pixels.bytes.resize(pixels.row_bytes() * std::size_t(height));
    std::byte* to = pixels.bytes.data();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c, to += sizeof(T)) {
                const T v = T(value(x, y, c));
                std::memcpy(to, &v, sizeof(T));
            }
    return pixels;
}

inline unsigned noise(int x, int y, int c) {
    unsigned state = unsigned(x) * 73856093u ^ unsigned(y) * 19349663u ^ unsigned(c) * 83492791u;
    state = (state ^ state >> 13) * 1274126177u;
    return state ^ state >> 16;
}

}  // namespace rakelight::test
