// SPDX-License-Identifier: Apache-2.0
#include <rakelight/tools/text_file.h>

#include <span>

#include "io/file.h"
#include "render/picture_steps.h"

namespace rakelight {

void check_text_output(const std::string& path) {
    try {
        check_output_place(path);
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

void save_text(const std::string& path, const std::string& text) {
    try {
        io::OutputFile file(path);
        file.write(std::as_bytes(std::span(text)));
        file.commit();
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

}  // namespace rakelight
