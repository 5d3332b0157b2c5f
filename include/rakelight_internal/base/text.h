// SPDX-License-Identifier: Apache-2.0
// Small texts that many messages need.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace rakelight {

/// ASCII letters alone, in any locale.
constexpr char lower_case(char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; }
inline std::string lower_case(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = lower_case(c);
    return out;
}

/// "1 light", "3 lights"; counted(2, "mesh", "meshes") where the plural is not the singular and an s.
inline std::string counted(std::uint64_t count, std::string_view one, std::string_view many = {}) {
    std::string text = std::to_string(count) + ' ';
    if (count == 1) return text.append(one);
    return many.empty() ? text.append(one).append(1, 's') : text.append(many);
}

}  // namespace rakelight
