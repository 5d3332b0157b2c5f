// SPDX-License-Identifier: Apache-2.0
// A configuration: the [render] of a world file without a world.
#pragma once
#include <string>
#include <vector>

#include <rakelight/io/world.h>

namespace rakelight::io::world {

/// @throws Error not_found, bad_file: with the file's name, line and column; anything but [render]
std::vector<WorldValue> read_settings(const std::string& path, Context& context);

}  // namespace rakelight::io::world
