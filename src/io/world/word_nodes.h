// SPDX-License-Identifier: Apache-2.0
// Values of a command line as a world file would have them.
#pragma once
#include <string_view>

#include "io/world/toml_tree.h"
#include "io/world/world_keys.h"

namespace rakelight::io::world {

/// What a key of this kind would hold: numbers of a list stand apart by commas, flags are on or off. Anything else
/// stays a text, which the check of the key refuses with a message. Without a place.
TomlNode node_of(Kind kind, std::string_view text);

}  // namespace rakelight::io::world
