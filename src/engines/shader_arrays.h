// SPDX-License-Identifier: Apache-2.0
// How much memory the variables of a GLSL text ask for: arrays, structs with arrays, arrays of those.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engines/shader_tokens.h"

namespace rakelight {

/// Numbers in all arrays and structs that a text declares: 256 KiB. Drivers on the processor keep local arrays for eight and more
/// pixels at once.
inline constexpr std::int64_t max_array_numbers = 65536;
/// Brackets in brackets, of any kind.
inline constexpr int max_shader_nesting = 128;

/// @param tokens  with their macros expanded
/// @throws Error bad_file: more than max_array_numbers, a size that is no constant of whole numbers, brackets nested too deep
void check_shader_arrays(const std::string& name, const std::vector<ShaderToken>& tokens);

}  // namespace rakelight
