// SPDX-License-Identifier: Apache-2.0
// Validation of enumerators, which callers may create by casts.
#pragma once
#include <string>
#include <type_traits>

namespace rakelight {

/// @param last the last enumerator of E, whose values are 0, 1, 2, ...
template <class E>
constexpr bool exists(E value, E last) {
    return static_cast<std::underlying_type_t<E>>(value) <= static_cast<std::underlying_type_t<E>>(last);
}

/// "there is no WHAT 99"
template <class E>
std::string no_such(const char* what, E value) {
    return std::string("there is no ") + what + " " + std::to_string(int(value));
}

}  // namespace rakelight
