// SPDX-License-Identifier: Apache-2.0
// Pictures of a saved scene that lie outside of its folder, where readers do not follow names.
#pragma once
#include <cstddef>
#include <string>

#include <rakelight/world.h>

namespace rakelight::viewer {

/// Copies pictures that lie outside of the folder of the world file at `path` into "NAME-files" beside it, and names the copies.
/// Models stay where they are. @return how many were copied @throws Error failed: one cannot be copied; not_found
std::size_t gather_pictures(WorldFile& world, const std::string& path);

}  // namespace rakelight::viewer
