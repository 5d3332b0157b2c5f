// SPDX-License-Identifier: Apache-2.0
// Where scenes come from: files of all formats, world files, built-in shapes.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

struct LoadOptions {
    bool allow_outside = false;  ///< references may leave the model's own folder tree
    /// Settings in [render] of a world file whose place others have taken, such as "camera-index": what they name need
    /// not be there.
    std::vector<std::string> overridden{};
    bool operator==(const LoadOptions&) const = default;
};

/// Loads a model file, a world file, or one of builtin:teapot, sphere, cylinder, cone, torus, plane, with what shape_of_words() takes
/// behind it. What was changed, guessed or dropped goes to context.report().
/// @throws Error not_found, bad_file
Scene load(const std::string& path, const LoadOptions& options, Context& context);

/// The same of a file that is in memory.
/// @param bytes  the whole file
/// @param path   where it would lie: its ending says the format as a file's does, what it names is looked for in its folder (the
///               working folder where it has none), and messages call it so
/// @throws Error not_found: what it names; bad_file; failed: formats that the import helper reads need room for a temporary file
Scene load(std::vector<std::byte> bytes, const std::string& path, const LoadOptions& options, Context& context);

}  // namespace rakelight
