// SPDX-License-Identifier: Apache-2.0
#include "io/obj/references.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <rakelight/base/error.h>
#include <rakelight_internal/base/text.h>

#include "io/files/file.h"
#include "io/obj/obj_lines.h"

namespace rakelight::io::obj {
namespace fs = std::filesystem;
namespace {

constexpr int most_searches_in_vain = 2000;

/// '\\' as '/', "a/./b" and "a/x/../b" folded, so that "materials/../textures/a.png" stays inside the model's folder.
std::string normal_form(std::string reference) {
    std::replace(reference.begin(), reference.end(), '\\', '/');
    return fs::path(reference).lexically_normal().generic_string();
}

}  // namespace

std::string ReferenceFinder::folder_of(const std::string& path) const {
    return fs::path(path).parent_path().lexically_relative(fs::path(model_path_).parent_path()).generic_string();
}

std::string ReferenceFinder::bare_name(const std::string& reference) {
    const std::size_t slash = reference.find_last_of("/\\");
    return slash == std::string::npos ? reference : reference.substr(slash + 1);
}

std::optional<std::string> ReferenceFinder::exact(const std::string& reference) const {
    try {
        std::string path = resolve_reference(model_path_, reference, allow_outside_);
        if (is_regular_file(path)) return path;
    } catch (const Error&) {  // outside the model's folder: as if it were not there
    }
    return std::nullopt;
}

const std::map<std::string, std::string>& ReferenceFinder::listing(const std::string& folder) {
    const auto [entry, is_new] = listings_.try_emplace(folder);
    if (!is_new) return entry->second;
    std::error_code error;
    const fs::path path = fs::path(model_path_).parent_path() / folder;
    for (fs::directory_iterator i(path.empty() ? fs::path(".") : path, error), end; !error && i != end;
         i.increment(error)) {
        const std::string name = i->path().filename().string();
        // Of names that differ in case only the first in byte order counts, on every file system.
        const auto [known, is_first] = entry->second.try_emplace(lower_case(name), name);
        if (!is_first && name < known->second) known->second = name;
    }
    return entry->second;
}

std::optional<std::string> ReferenceFinder::other_case(const std::string& reference) {
    std::string folder;
    for (const fs::path& part : fs::path(reference)) {
        const std::string name = part.string();
        if (name == ".." || name.empty() || part.is_absolute()) return std::nullopt;
        const auto& names = listing(folder);
        const auto known = names.find(lower_case(name));
        if (known == names.end()) return std::nullopt;
        folder += (folder.empty() ? "" : "/") + known->second;
    }
    return folder.empty() ? std::nullopt : exact(folder);
}

std::optional<FoundFile> ReferenceFinder::search(const std::string& reference, const std::string& folder) {
    const std::string plain = normal_form(reference),
                      inner = folder.empty() ? plain : normal_form(folder + "/" + reference);
    for (const std::string& candidate : {inner, plain})
        if (auto path = exact(candidate)) return FoundFile{*path, false};
    for (const std::string& candidate : {inner, plain})
        if (auto path = other_case(candidate)) return FoundFile{*path, true};
    if (auto path = other_case(bare_name(plain))) return FoundFile{*path, true};
    return std::nullopt;
}

std::optional<FoundFile> ReferenceFinder::find(const std::string& reference, const std::string& folder) {
    if (reference.empty() || reference.size() > 4096 || reference.find('\0') != std::string::npos) return std::nullopt;
    if (searches_in_vain_ >= most_searches_in_vain) return std::nullopt;
    auto found = search(reference, folder);
    if (!found) ++searches_in_vain_;
    return found;
}

}  // namespace rakelight::io::obj
