// SPDX-License-Identifier: Apache-2.0
// STL bytes that are in memory -> scene.
#pragma once
#include <string_view>

#include "io/reader.h"

namespace rakelight::io::stl {

/// A root node, and a node with a mesh for each solid of a text file, or one of a binary file. No normals.
/// @param path  where the file would be: its name in messages
/// @throws Error bad_file
Scene read_stl_bytes(std::string_view file, const std::string& path, Context& context);

}  // namespace rakelight::io::stl
