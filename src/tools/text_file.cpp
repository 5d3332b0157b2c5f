// SPDX-License-Identifier: Apache-2.0
#include <rakelight_internal/tools/text_file.h>

#include <filesystem>
#include <system_error>

#include "io/files/output_file.h"
#include "render/check_request.h"

namespace rakelight {
namespace {

bool is_there(const std::string& path) {
    std::error_code ignored;
    return path.find('\0') == std::string::npos && std::filesystem::exists(path, ignored);
}

}  // namespace

void check_text_output(const std::string& path) {
    try {
        check_output_place(path);
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

void save_bytes(const std::string& path, std::span<const std::byte> bytes, Saving saving) {
    try {
        if (saving == Saving::in_place && is_there(path)) return io::overwrite_file(path, bytes);
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
