// SPDX-License-Identifier: Apache-2.0
#include <rakelight/tools/text_file.h>

#include "io/file.h"
#include "io/overwrite_file.h"
#include "render/picture_steps.h"

namespace rakelight {

void check_text_output(const std::string& path) {
    try {
        check_output_place(path);
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

void save_bytes(const std::string& path, std::span<const std::byte> bytes, Saving saving) {
    try {
        if (saving == Saving::in_place && io::is_regular_file(path)) return io::overwrite_file(path, bytes);
        io::OutputFile file(path);
        file.write(bytes);
        file.commit();
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

void save_text(const std::string& path, const std::string& text) {
    save_bytes(path, std::as_bytes(std::span(text)), Saving::atomic);
}

}  // namespace rakelight
