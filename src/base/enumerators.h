// SPDX-License-Identifier: Apache-2.0
// Whether an enumerator exists: numbers of callers come in by casts.
#pragma once
#include <string>
#include <type_traits>

namespace rakelight {

/// @param last  the last enumerator of E, whose numbers begin with 0 and have no gap
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
