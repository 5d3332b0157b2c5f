// SPDX-License-Identifier: Apache-2.0
#include "view_verb.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <rakelight/error.h>

namespace rakelight::cli {

bool is_model_to_view(int argc, const char* const* argv) {
    if (argc < 2 || (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY"))) return false;
    const std::string word = argv[1];
    std::error_code ignored;
    return word.starts_with("builtin:") ||
           (word.find('.') != std::string::npos && std::filesystem::is_regular_file(word, ignored));
}

void become_viewer(int argc, const char* const* argv, int first) {
    const std::string name = "rakelight-view";
    std::error_code fault;
    const std::filesystem::path beside = std::filesystem::read_symlink("/proc/self/exe", fault).parent_path() / name;
    std::vector<char*> words;
    std::string path = beside.string();
    words.push_back(path.data());
    for (int i = first; i < argc; ++i) words.push_back(const_cast<char*>(argv[i]));  // execv() changes none
    words.push_back(nullptr);
    if (!fault) execv(path.c_str(), words.data());
    execvp(name.c_str(), words.data());
    throw Error(ErrorCode::failed, "the viewer '" + name + "' is neither beside this program nor in PATH", {},
                "build it with -DRAKELIGHT_VIEWER=ON, which needs GLFW and Dear ImGui");
}

}  // namespace rakelight::cli
