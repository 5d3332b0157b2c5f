// SPDX-License-Identifier: Apache-2.0
// The GLSL files of the settings `lighting` and `vertex-shader`, read again when they change.
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include <rakelight/engines/engine.h>

namespace rakelight::viewer {

class ShaderFiles {
public:
    struct Texts {
        std::string lighting, vertex;
    };
    /// To be called now and then. @param settings  name the files, and have the texts that were read
    /// @return the texts of both, once one file has stayed the same for a call and the texts are others
    /// @throws Error not_found, bad_file, usage: once for each change
    std::optional<Texts> changed(const RenderSettings& settings);

private:
    struct Watched {
        std::string file;
        std::filesystem::file_time_type read_time{}, changed_time{};
        bool has_changed(const std::string& now);
    };
    std::array<Watched, 2> watched_;
};

}  // namespace rakelight::viewer
