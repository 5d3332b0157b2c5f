// SPDX-License-Identifier: Apache-2.0
#include "display_path.h"

#include <cstdlib>
#include <filesystem>

namespace rakelight::viewer {
namespace {

namespace fs = std::filesystem;

std::string working_folder() {
    std::error_code fault;
    const fs::path folder = fs::current_path(fault);
    return fault ? std::string() : folder.generic_string();
}

std::string home_folder() {
    const char* const home = std::getenv("HOME");
    return home && fs::path(home).is_absolute() ? fs::path(home).lexically_normal().generic_string() : std::string();
}

/// "folder/", or nothing for the root: it would shorten every path.
std::string prefix_of(std::string folder) {
    while (folder.ends_with('/')) folder.pop_back();
    return folder.empty() ? folder : folder + "/";
}

/// Removes a folder at the start of a path, but not inside a name.
void replace_folder(std::string& text, const std::string& prefix, const std::string& by) {
    if (prefix.empty()) return;
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at)) {
        const bool begins = at == 0 || std::string_view(" '\"\n\t(:=,").find(text[at - 1]) != std::string_view::npos;
        if (begins) text.replace(at, prefix.size(), by);
        at += begins ? by.size() : prefix.size();
    }
}

}  // namespace

std::string short_path(const std::string& file) { return with_short_paths(file); }

std::string display_path(const std::string& file) {
    const std::string path = short_path(file);
    return fs::path(path).is_absolute() ? fs::path(path).filename().string() : path;
}

std::string with_short_paths(std::string text, const std::string& model_file) {
    const fs::path model = model_file;
    replace_folder(text, prefix_of(working_folder()), "");
    if (model.is_absolute()) replace_folder(text, prefix_of(model.parent_path().generic_string()), "");
    replace_folder(text, prefix_of(home_folder()), "~/");
    return text;
}

}  // namespace rakelight::viewer
