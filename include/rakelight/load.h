// SPDX-License-Identifier: Apache-2.0
// Where scenes come from: files of all formats, world files, built-in shapes.
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/export.h>
#include <rakelight/scene.h>

namespace rakelight {

/// A file that lies in memory: load() takes its bytes where its name is asked for.
struct MemoryFile {
    std::string name{};  ///< its ending says the format; what it names is looked for in its folder
    std::shared_ptr<const std::vector<std::byte>> bytes{};  ///< the whole file
    bool operator==(const MemoryFile&) const = default;
};

/// What load() may read.
struct LoadOptions {
    bool allow_outside = false;  ///< references may leave the model's own folder tree
    std::vector<MemoryFile> memory_files{};
    /// More of what load() takes, put into the same scene, each where its own coordinates say. load() takes them into account
    /// when it reads `path`, but not when it reads these.
    std::vector<std::string> joined{};
    /// Settings in [render] of a world file whose place others have taken, such as "camera-index": what they name need
    /// not be there.
    std::vector<std::string> overridden{};
    bool operator==(const LoadOptions&) const = default;
};

/// Loads a model file, a world file, or one of builtin:teapot, sphere, cylinder, cone, torus, plane, with what shape_of_words() takes
/// behind it. What was changed, guessed or dropped goes to context.report().
/// @throws Error not_found, bad_file
RL_API Scene load(const std::string& path, const LoadOptions& options, Context& context);

/// The same of a file that is in memory.
/// @param bytes  the whole file
/// @param path   where it would lie: its ending says the format as a file's does, what it names is looked for in its folder (the
///               working folder where it has none), and messages call it so
/// @throws Error not_found: what it names; bad_file; failed: formats that the import helper reads need room for a temporary file
RL_API Scene load(std::vector<std::byte> bytes, const std::string& path, const LoadOptions& options, Context& context);

}  // namespace rakelight
