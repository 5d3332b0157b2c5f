// SPDX-License-Identifier: Apache-2.0
// Copies the files that a model names to the same relative paths beside a model that is written to another folder.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/context.h>

namespace rakelight::io {

std::filesystem::path folder_of(const std::string& path);  ///< "." for a bare name
bool is_same_folder(const std::string& a, const std::string& b);
/// Whether both are the name of one file, by whatever way through folders; it need not exist.
bool is_same_place(const std::string& a, const std::string& b);

/// By a temporary name, as OutputFile. @throws Error failed: cannot write
void write_file(const std::string& path, std::span<const std::byte> bytes);

/// A path inside a model's folder: relative and not upwards.
bool is_inside(const std::string& name);

/// A file that a model names.
struct NamedFile {
    std::string name;  ///< from the model's folder; is_inside()
    std::string path;  ///< where it was found
};

/// Copies files to the folder of `output`, each under its name; those that exist with these bytes stay.
/// @throws Error failed, before anything is copied: one is there with other bytes; not_found, bad_file: cannot be read
void copy_beside(const std::vector<NamedFile>& files, const std::string& output, Context& context);

}  // namespace rakelight::io
