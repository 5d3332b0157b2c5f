// SPDX-License-Identifier: Apache-2.0
#include "shader_files.h"

#include <utility>
#include <vector>

#include <rakelight/world/render_keys.h>
#include <rakelight/world/request.h>

namespace rakelight::viewer {

bool ShaderFiles::Watched::has_changed(const std::string& now) {
    if (now.empty()) return false;
    std::error_code fault;
    const std::filesystem::file_time_type time = std::filesystem::last_write_time(now, fault);
    if (fault) return false;  // it may be on its way: editors write a new file instead of the old one
    if (now != file) {
        file = now, read_time = {}, changed_time = time;  // it may have changed since others read it
        return false;
    }
    if (time == read_time || time != std::exchange(changed_time, time)) return false;
    read_time = time;
    return true;
}

std::optional<ShaderFiles::Texts> ShaderFiles::changed(const RenderSettings& settings) {
    const bool is_lighting_new = watched_[0].has_changed(settings.lighting_name);
    const bool is_vertex_new = watched_[1].has_changed(settings.vertex_name);
    if (!is_lighting_new && !is_vertex_new) return {};
    std::vector<WorldValue> values;
    if (!settings.lighting_name.empty()) values.push_back({.key = "lighting", .words = {settings.lighting_name}});
    if (!settings.vertex_name.empty()) values.push_back({.key = "vertex-shader", .words = {settings.vertex_name}});
    PictureRequest request;
    read_render_keys(values, request);
    Texts now{request.settings.lighting_text, request.settings.vertex_text};
    if (now.lighting == settings.lighting_text && now.vertex == settings.vertex_text) return {};
    return now;
}

}  // namespace rakelight::viewer
