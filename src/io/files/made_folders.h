// SPDX-License-Identifier: Apache-2.0
// Folders that are made for an output, and removed again if it is not written; whether they could be made.
#pragma once
#include <deque>
#include <string>

#include "io/files/unfinished_outputs.h"

namespace rakelight::io {

/// The missing folders above a file that is to be written, from the outermost. They are removed again, where they are empty,
/// unless the file was written.
class MadeFolders {
public:
    MadeFolders() = default;
    ~MadeFolders();
    MadeFolders(const MadeFolders&) = delete;
    MadeFolders& operator=(const MadeFolders&) = delete;
    /// @throws Error failed, with `path` as its file
    void make_above(const std::string& path);
    void keep();
    void give_to(MadeFolders& other);  ///< which removes them then

private:
    std::deque<std::string> folders_;          ///< those that were made
    std::deque<UnfinishedOutput> unfinished_;  ///< [folders]
};

/// Whether an output can have its name: folders that are missing are made when the file is.
/// @throws Error failed: something else has the name of such a folder, or the output is a folder
void check_output_place(const std::string& output);

}  // namespace rakelight::io
