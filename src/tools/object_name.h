// SPDX-License-Identifier: Apache-2.0
// What an object is called in tables and messages.
#pragma once
#include <string>

#include <rakelight/base/error.h>
#include <rakelight/tools/inspect.h>

namespace rakelight {

inline constexpr std::size_t max_name = 40;  ///< bytes of a name

/// The name, safe for a terminal, or "node 3" where there is none.
inline std::string name_or_number(const Inspection& i, std::uint32_t object) {
    const ObjectSummary& o = i.objects[object];
    return o.name.empty() ? "node " + std::to_string(o.node) : one_line(o.name, max_name);
}

/// 'name' or node 3
inline std::string quoted_name(const Inspection& i, std::uint32_t object) {
    return i.objects[object].name.empty() ? name_or_number(i, object) : "'" + name_or_number(i, object) + "'";
}

}  // namespace rakelight
