// SPDX-License-Identifier: Apache-2.0
// Any bytes as a picture: either pixels that fit their size, or one Error.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "io/pictures/image_io.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    rakelight::Context context({.threads = 1, .max_memory = 64u << 20});
    try {
        const rakelight::Pixels pixels = rakelight::io::decode_image(std::as_bytes(std::span(data, size)), context);
        const bool whole = pixels.width > 0 && pixels.height > 0 && pixels.channels >= 1 && pixels.channels <= 4 &&
                           pixels.bytes.size() == pixels.row_bytes() * std::size_t(pixels.height);
        if (!whole) std::abort();
    } catch (const rakelight::Error& error) {
        if (error.code() != rakelight::ErrorCode::bad_file) std::abort();
    }
    return 0;
}
