// SPDX-License-Identifier: Apache-2.0
#include "view_verb.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <rakelight/error.h>

namespace rakelight::cli {

void become_viewer(int argc, const char* const* argv) {
    const std::string name = "rakelight-view";
    std::error_code fault;
    const std::filesystem::path beside = std::filesystem::read_symlink("/proc/self/exe", fault).parent_path() / name;
    std::vector<char*> words;
    std::string path = beside.string();
    words.push_back(path.data());
    for (int i = 2; i < argc; ++i) words.push_back(const_cast<char*>(argv[i]));  // execv() changes none
    words.push_back(nullptr);
    if (!fault) execv(path.c_str(), words.data());
    execvp(name.c_str(), words.data());
    throw Error(ErrorCode::failed, "the viewer '" + name + "' is neither beside this program nor in PATH", {},
                "build it with -DRAKELIGHT_VIEWER=ON, which needs GLFW and Dear ImGui");
}

}  // namespace rakelight::cli
