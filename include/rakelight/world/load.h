// SPDX-License-Identifier: Apache-2.0
// Loading of scenes: model files, world files, built-in shapes.
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// A file in memory. If load() opens a file of this name, it reads these bytes instead.
struct MemoryFile {
    std::string name{};  ///< its ending selects the format; references are relative to its folder
    std::shared_ptr<const std::vector<std::byte>> bytes{};  ///< the whole file
    bool operator==(const MemoryFile&) const = default;
};

/// Options of load().
struct LoadOptions {
    bool allow_outside = false;  ///< references may leave the model's folder tree
    bool allow_shaders = false;  ///< [render] of a world file may name GLSL files, which the OpenGL driver runs
    std::vector<MemoryFile> memory_files{};
    /// Paths of further inputs. load() merges them into the scene of `path`. Each input keeps its coordinates.
    std::vector<std::string> joined{};
    /// Keys in [render] of a world file that the caller overrides, such as "camera-index". What these settings of the
    /// file refer to need not exist.
    std::vector<std::string> overridden{};
    bool operator==(const LoadOptions&) const = default;
};

/// Loads a model file, a world file or a built-in shape. Built-in shapes are "builtin:teapot", "builtin:sphere" and so
/// on, with parameters as in shape_of_words(). context.report() lists changed, guessed and dropped data.
/// @throws Error not_found, bad_file
RL_API Scene load(const std::string& path, const LoadOptions& options, Context& context);

/// The same for a file in memory.
/// @param bytes  the whole file
/// @param path  name of the file for messages. Its ending selects the format. References in the file are relative to
///         the
///        folder of this path; without a folder, to the working folder
/// @throws Error not_found: a referenced file; bad_file; failed: no space for the temporary file of the import helper
RL_API Scene load(std::vector<std::byte> bytes, const std::string& path, const LoadOptions& options, Context& context);

}  // namespace rakelight
