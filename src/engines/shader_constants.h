// SPDX-License-Identifier: Apache-2.0
// Constant expressions of whole numbers in GLSL texts.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string_view>

#include "engines/shader_tokens.h"

namespace rakelight {

/// Constants by name; none: several with one name, or a value that cannot be told.
using ShaderConstants = std::map<std::string_view, std::optional<std::int64_t>>;

/// @return none: not of whole numbers, names, int(), uint(), brackets and the operators of C without ?:, or a number on the way
///         is outside of 32 bits with a sign
std::optional<std::int64_t> constant_value(std::span<const ShaderToken> expression, const ShaderConstants& constants);

}  // namespace rakelight
