// SPDX-License-Identifier: Apache-2.0
// A folder that appears complete or not at all.
#pragma once
#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include <rakelight/image/image.h>

#include "io/files/made_folders.h"

namespace rakelight::stages {

/// Files go into a folder beside the target; finish() puts it in its place. What is not finished is removed.
class NewFolder {
public:
    /// The target must be absent, empty, or hold only files that its list (stages.json) names.
    /// @throws Error failed: it holds other things, is no folder, or cannot be written
    explicit NewFolder(const std::string& target);
    ~NewFolder();
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;

    void write(const std::string& name, const std::string& text);
    void write(const std::string& name, const Pixels& pixels);
    /// Writes the list and moves everything in place.
    void finish();
    const std::vector<std::string>& names() const { return names_; }

private:
    /// The path of a new file, which an end by a signal takes with it.
    std::string watched(const std::string& name);

    std::filesystem::path target_, work_;
    io::MadeFolders above_;                        ///< outlives what is in them
    std::deque<io::UnfinishedOutput> unfinished_;  ///< the folder and its files
    std::vector<std::string> names_;
};

}  // namespace rakelight::stages
