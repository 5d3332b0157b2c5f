// SPDX-License-Identifier: Apache-2.0
// What macros make of a GLSL text: expanded as the driver's preprocessor does, but only as far as a bound on the tokens.
#pragma once
#include <deque>
#include <string>
#include <vector>

#include "engines/shader_tokens.h"

namespace rakelight {

/// Tokens that a text may have, with those that its macros make. A driver's compiler takes gigabytes and minutes where they
/// are a few millions.
inline constexpr std::size_t max_macro_tokens = 200'000;

struct ExpandedShader {
    std::vector<ShaderToken> all;
    std::deque<std::string> pasted;  ///< words that ## makes: what tokens refer to beside the text
};

/// The tokens of a text with its macros expanded; they have the lines where the macros are used. Parts that an #if surely
/// leaves out are not there. Where it depends on the engine or the driver whether or how a macro is defined, all that it may be
/// stands one behind the other: nothing that the driver sees is missing.
/// @throws Error bad_file: more tokens than max_macro_tokens, calls nested too deep, a definition of another form
ExpandedShader expanded_macros(const std::string& name, const ShaderTokens& tokens);

}  // namespace rakelight
