// SPDX-License-Identifier: Apache-2.0
// PLY text or bytes that are in memory -> scene.
#pragma once
#include <string_view>

#include "io/reader.h"

namespace rakelight::io::ply {

/// @param path  where the file would be: for textures beside it, its name in messages
/// @throws Error bad_file
Scene read_ply_bytes(std::string_view file, const std::string& path, const ReadOptions& options, Context& context);

}  // namespace rakelight::io::ply
