// SPDX-License-Identifier: Apache-2.0
// A saved scene with the files that it names: those outside of its folder, where readers do not follow names, come as copies.
#pragma once
#include <cstddef>
#include <string>

#include <rakelight/io/world.h>

namespace rakelight::viewer {

/// Saves a world, and copies pictures and lighting texts that lie outside of its folder into "NAME-files" beside it. Models stay where
/// they are. Where something fails nothing of it is left. @return how many were copied
/// @throws Error failed: one cannot be copied; not_found; as save_world()
std::size_t save_with_files(WorldFile world, const std::string& path);

}  // namespace rakelight::viewer
