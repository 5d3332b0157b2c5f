// SPDX-License-Identifier: Apache-2.0
// What a command line names as models: files, folders of files, standard input.
#pragma once
#include <span>
#include <string>
#include <vector>

#include <rakelight/world/load.h>

namespace rakelight::cli {

/// The folder of a model.
struct InputFolder {
    /// {dir}: below the folder that was named, else as the file was written; "." where there is none.
    std::string as_written;
    std::string below;  ///< below the folder that was named; "." where the file was named
};

/// One model.
struct Input {
    std::string path;
    InputFolder folder;
};

bool is_folder(const std::string& path);
/// Whether an output or a reference is the name of a folder: one that ends with '/', or that is there and named as no picture or model.
bool means_folder(const std::string& path);

/// Folders as the models and worlds in them, by name and not hidden; all else as it is.
/// @throws Error not_found: a folder that cannot be read or holds no model
std::vector<Input> expanded(std::span<const std::string> words, bool is_recursive);

/// All of standard input. @param format  the ending of its name: "glb"; empty: its content says it
/// @param most  [bytes] 0: any number
/// @throws Error usage: it is a terminal; bad_file: more than `most`; not_found: it cannot be read
MemoryFile standard_input(const std::string& format, std::uint64_t most);

}  // namespace rakelight::cli
