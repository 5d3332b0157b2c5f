// SPDX-License-Identifier: Apache-2.0
// Linear pixels -> rows of components as image files take them.
#pragma once
#include <cstddef>
#include <cstdint>

#include <rakelight/image/image.h>
#include <rakelight/math/vector.h>

#include "image/tone_curves.h"

namespace rakelight {

/// What a picture file holds: 3 channels, or 4 with alpha; display values (u8, sRGB) or linear light (f32).
struct PixelFormat {
    Component component = Component::u8;
    int channels = 3;
    std::size_t bytes() const { return size_of(component) * std::size_t(channels); }
};

/// Rows of a picture to draw on.
struct PictureRows {
    PixelFormat format;
    int x = 0, y = 0;              ///< [px] of the first pixel, in the whole picture
    int width = 0, height = 0;     ///< [px]
    std::byte* bytes = nullptr;    ///< [height * width] as convert_row() makes them
    const float* depth = nullptr;  ///< [m] [height * width] along the view axis; null: not known
};

/// Converts `count` pixels; `out` takes count * format.bytes(). Engines deliver colors that are not premultiplied by
/// alpha: 8-bit formats store them like this, EXR by its convention premultiplied. Exposure and curve of `tone` apply
/// only to display values; the background is laid behind in both cases.
void convert_row(const vec4* pixels, std::size_t count, const PixelFormat& format, const ToneCurve& tone,
                 std::byte* out);

/// The same of pixels that are sRGB codes already, R in the low byte; `out` takes count * channels bytes.
void pack_row(const std::uint32_t* srgb8, std::size_t count, int channels, std::byte* out);

}  // namespace rakelight
