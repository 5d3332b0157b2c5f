// SPDX-License-Identifier: Apache-2.0
// The file of --lighting FILE.glsl, read again when it changes.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace rakelight::viewer {

class LightingFile {
public:
    /// To be called now and then. @param file  RenderSettings::lighting_name; empty: none
    /// @return its text, once it has changed and then stayed the same for a call
    /// @throws Error not_found, bad_file: once for each change
    std::optional<std::string> changed(const std::string& file);

private:
    std::string file_;
    std::filesystem::file_time_type read_time_{}, changed_time_{};
};

}  // namespace rakelight::viewer
