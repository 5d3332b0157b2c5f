// SPDX-License-Identifier: Apache-2.0
#include "version_text.h"

#include <rakelight/version.h>

namespace rakelight::cli {
namespace {

std::string list(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

}  // namespace

std::string version_text() {
    const BuildInfo info = build_info();
    return "rakelight " + info.version + "\n" + "engines:          " + list(info.engines) + "\n" +
           "model formats:    " + info.model_formats + "\n" + "textures read:    " + info.image_formats_read + "\n" +
           "pictures written: " + info.image_formats_written + "\n" + "instruction set:  " + info.isa +
           " (available: " + list(info.isas) + ")\n" + "threads:          " + std::to_string(info.threads) + "\n" +
           (info.left_out.empty() ? "" : "left out:         " + list(info.left_out) + "\n");
}

}  // namespace rakelight::cli
