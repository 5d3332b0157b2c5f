// SPDX-License-Identifier: Apache-2.0
#include "io/files/made_folders.h"

#include <filesystem>
#include <system_error>

#include <rakelight/base/error.h>

namespace rakelight::io {
namespace fs = std::filesystem;

MadeFolders::~MadeFolders() {
    std::error_code ignored;
    while (!folders_.empty()) {
        unfinished_.pop_back();
        fs::remove(folders_.back(), ignored);  // those that are not empty stay
        folders_.pop_back();
    }
}

void MadeFolders::make_above(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    fs::path sofar;
    for (const fs::path& part : folder) {
        sofar /= part;
        std::error_code error;
        if (part.empty() || fs::exists(fs::symlink_status(sofar, error))) continue;
        const bool is_made = fs::create_directory(sofar, error);
        if (error)
            throw Error(ErrorCode::failed,
                        "the folder '" + one_line(sofar.string(), 160) + "' cannot be made: " + error.message())
                .with_file(path);
        if (!is_made) continue;  // somebody else was faster
        folders_.push_back(sofar.string());
        unfinished_.emplace_back().watch(sofar.string());
    }
}

void check_output_place(const std::string& output) {
    std::error_code ignored;
    const fs::path path(output);
    fs::path folder = path.parent_path();
    while (!folder.empty() && !fs::exists(fs::symlink_status(folder, ignored)))
        folder = folder.has_filename() ? folder.parent_path() : folder.parent_path().parent_path();
    if (!folder.empty() && !fs::is_directory(folder, ignored))
        throw Error(ErrorCode::failed, "'" + one_line(folder.string(), 160) + "' is not a folder");
    if (fs::is_directory(path, ignored)) throw Error(ErrorCode::failed, "a folder has this name");
}

void MadeFolders::give_to(MadeFolders& other) {
    for (const std::string& folder : folders_) {
        other.folders_.push_back(folder);
        other.unfinished_.emplace_back().watch(folder);
    }
    keep();
}

void MadeFolders::keep() {
    unfinished_.clear();
    folders_.clear();
}

}  // namespace rakelight::io
