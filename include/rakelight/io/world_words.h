// SPDX-License-Identifier: Apache-2.0
// Materials and shapes of world files, written as words of a command line.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/io/world.h>

namespace rakelight {

/// Parses words "KEY=VALUE" with the keys of [[material]], and checks the values. The elements of lists are separated
/// by commas, flags are on or off, and colors are linear or "#rrggbb".
/// @throws Error usage
RL_API std::vector<WorldValue> material_values(std::span<const std::string> words);

/// Parses a shape such as "sphere" or "sphere:tolerance=0.01:radius=2" with the keys of [[primitive]], and checks the
/// values.
/// @throws Error usage
RL_API WorldPrimitive shape_of_words(std::string_view words);

}  // namespace rakelight
