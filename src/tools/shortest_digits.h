// SPDX-License-Identifier: Apache-2.0
// Numbers for people who want to compute with them.
#pragma once
#include <charconv>
#include <string>

namespace rakelight {

/// The fewest digits that read back as the same number.
template <class Number>
std::string digits(Number v) {
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, v).ptr;
    return {buffer, end};
}

}  // namespace rakelight
