// SPDX-License-Identifier: Apache-2.0
// Loading of scenes: model files, world files, built-in shapes.
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/export.h>
#include <rakelight/scene.h>

namespace rakelight {

/// A file in memory: load() reads its bytes in place of a file with its name.
struct MemoryFile {
    std::string name{};  ///< its ending selects the format; references are relative to its folder
    std::shared_ptr<const std::vector<std::byte>> bytes{};  ///< the whole file
    bool operator==(const MemoryFile&) const = default;
};

/// Options of load().
struct LoadOptions {
    bool allow_outside = false;  ///< references may leave the model's folder tree
    std::vector<MemoryFile> memory_files{};
    /// More inputs as for load(), merged into the same scene with their own coordinates. They apply when load() reads
    /// `path`, but not when it reads these inputs.
    std::vector<std::string> joined{};
    /// Overridden settings in [render] of a world file, such as "camera-index": what they refer to need not exist.
    std::vector<std::string> overridden{};
    bool operator==(const LoadOptions&) const = default;
};

/// Loads a model file, a world file, or one of builtin:teapot, sphere, cylinder, cone, torus, plane, with parameters as
/// in shape_of_words(). Changed, guessed and dropped data is listed in context.report().
/// @throws Error not_found, bad_file
RL_API Scene load(const std::string& path, const LoadOptions& options, Context& context);

/// The same for a file in memory.
/// @param bytes  the whole file
/// @param path its name: the ending selects the format, references are relative to its folder (default: the working
///         folder), and messages use it
/// @throws Error not_found: a referenced file; bad_file; failed: no space for the temporary file of the import helper
RL_API Scene load(std::vector<std::byte> bytes, const std::string& path, const LoadOptions& options, Context& context);

}  // namespace rakelight
