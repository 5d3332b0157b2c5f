// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/new_pixels.h"

#include "base/format_text.h"

namespace rakelight::io::codec {

void bad_picture(const std::string& reason, const std::string& advice) {
    throw Error(ErrorCode::bad_file, reason, {}, advice);
}

Pixels make_pixels(std::uint64_t width, std::uint64_t height, int channels, Component component, Want want,
                   Context& context) {
    if (width == 0 || height == 0) bad_picture("the picture has no pixels");
    if (width > max_side || height > max_side)
        bad_picture(format_text("the picture is {} x {} pixels, more than {} per side", width, height, max_side));
    Pixels pixels{int(width), int(height), channels, component, false, {}};
    if (want == Want::header) return pixels;
    const std::uint64_t size = std::uint64_t(pixels.row_bytes()) * height;
    pixels.charge = share(MemoryCharge(context.memory(), size, "the picture"));
    pixels.bytes.resize(std::size_t(size));
    return pixels;
}

}  // namespace rakelight::io::codec
