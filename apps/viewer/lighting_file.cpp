// SPDX-License-Identifier: Apache-2.0
#include "lighting_file.h"

#include <rakelight/request.h>

namespace rakelight::viewer {

std::optional<std::string> LightingFile::changed(const std::string& file) {
    if (file.empty()) return {};
    std::error_code fault;
    const std::filesystem::file_time_type now = std::filesystem::last_write_time(file, fault);
    if (fault) return {};  // it may be on its way: editors write a new file instead of the old one
    if (file != file_) {
        file_ = file, read_time_ = changed_time_ = now;
        return {};
    }
    if (now == read_time_) return {};
    if (now != std::exchange(changed_time_, now)) return {};
    read_time_ = now;
    const WorldValue value{.key = "lighting", .words = {file}};
    PictureRequest request;
    read_render_keys({&value, 1}, request);
    return request.settings.lighting_text;
}

}  // namespace rakelight::viewer
