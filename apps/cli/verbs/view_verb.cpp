// SPDX-License-Identifier: Apache-2.0
#include "view_verb.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <rakelight/base/error.h>

#include "../file_uri.h"
#include "../inputs.h"

namespace rakelight::cli {
namespace {

constexpr const char* name = "rakelight-view";

/// Empty: this program's place is not known.
std::string beside_this_program() {
    std::error_code fault;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", fault);
    return fault ? std::string() : (program.parent_path() / name).string();
}

bool is_set(const char* variable) {
    const char* const value = std::getenv(variable);
    return value && *value;
}

bool is_program(const std::string& path) { return !path.empty() && access(path.c_str(), X_OK) == 0; }

bool is_in_path() {
    const char* const value = std::getenv("PATH");
    std::string folders = value ? value : "";
    for (std::size_t at = 0; at <= folders.size();) {
        const std::size_t end = std::min(folders.find(':', at), folders.size());
        if (is_program((std::filesystem::path(folders.substr(at, end - at)) / name).string())) return true;
        at = end + 1;
    }
    return false;
}

}  // namespace

bool can_view() {
    const bool has_display = is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
    return has_display && (is_program(beside_this_program()) || is_in_path());
}

void become_viewer(const std::vector<std::string>& words, const std::vector<std::string>& models, bool is_recursive) {
    std::vector<std::string> all{beside_this_program()};
    for (const std::string& word : words) {
        if (word == "--recursive") continue;
        const bool is_model = std::ranges::find(models, word) != models.end();
        const std::string path = is_model ? path_of_uri(word) : word;
        if (!is_model || !is_folder(path)) {
            all.push_back(path);
            continue;
        }
        for (const Input& input : expanded({&path, 1}, is_recursive)) all.push_back(input.path);
    }
    std::vector<char*> given;
    for (std::string& word : all) given.push_back(word.data());
    given.push_back(nullptr);
    if (!all[0].empty()) execv(given[0], given.data());
    execvp(name, given.data());
    throw Error(ErrorCode::failed, "the viewer '" + std::string(name) + "' is neither beside this program nor in PATH",
                {}, "build it with -DRAKELIGHT_VIEWER=ON, which needs GLFW and Dear ImGui");
}

}  // namespace rakelight::cli
