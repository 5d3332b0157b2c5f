// SPDX-License-Identifier: Apache-2.0
#include "image/decode.h"

#include "base/enumerators.h"
#include "base/format_text.h"

namespace rakelight {
namespace {

/// Without products that could overflow: both sides may be 2^31 - 1.
bool is_whole(const Pixels& p) {
    const std::size_t rows = std::size_t(p.height);
    return p.bytes.size() % rows == 0 && p.bytes.size() / rows == p.row_bytes();
}

}  // namespace

Pixels decode(const EncodedImage& image, Context& context) {
    if (image.measure) image.measure(image, context);
    return decode_measured(image, context);
}

Pixels decode_measured(const EncodedImage& image, Context& context) {
    if (!image.decode) throw Error(ErrorCode::bad_file, "the image has no decoder");
    Pixels pixels = image.decode(image, context);
    if (pixels.width == 0 || pixels.height == 0) throw Error(ErrorCode::bad_file, "the picture has no pixels");
    if (pixels.width < 0 || pixels.height < 0 || pixels.channels < 1 || pixels.channels > 4 ||
        !exists(pixels.component, Component::f32))
        throw Error(ErrorCode::bad_file, format_text("the decoder gave a picture of {} x {} pixels with {} channels",
                                                     pixels.width, pixels.height, pixels.channels));
    if (!is_whole(pixels))
        throw Error(ErrorCode::bad_file,
                    format_text("the decoder gave {} bytes for {} x {} pixels of {} channels", pixels.bytes.size(),
                                pixels.width, pixels.height, pixels.channels));
    return pixels;
}

}  // namespace rakelight
