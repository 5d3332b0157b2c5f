// SPDX-License-Identifier: Apache-2.0
// Colors as text: CSS names and codes.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace rakelight {

/// sRGB codes of names such as "white" (CSS Color Module Level 4, section 6.1, in any case), "#rgb" or "#rrggbb".
std::optional<std::array<std::uint8_t, 3>> color_by_text(std::string_view text);

/// All names, in lower case.
std::vector<std::string_view> color_names();

}  // namespace rakelight
