// SPDX-License-Identifier: Apache-2.0
// Any bytes as a picture that is read row by row: rows of a size that was allowed, or one Error.
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "io/pictures/image_rows.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const int file = memfd_create("picture", 0);
    if (file < 0 || ftruncate(file, 0) != 0 || pwrite(file, data, size, 0) != ssize_t(size)) std::abort();
    rakelight::Context context({.threads = 1, .max_memory = 64u << 20});
    try {
        const auto reader = rakelight::io::read_rows("/proc/self/fd/" + std::to_string(file), context);
        const rakelight::io::RowHeader& header = reader->header();
        std::vector<std::byte> row(std::size_t(header.width) * header.kind.pixel_bytes());
        for (int y = 0; y < header.height; ++y) reader->read_row(row.data());
    } catch (const rakelight::Error& error) {
        if (error.code() != rakelight::ErrorCode::bad_file) std::abort();
    }
    return 0;
}
