// SPDX-License-Identifier: Apache-2.0
#include <rakelight_internal/base/file_ending.h>
#include <rakelight_internal/base/text.h>

namespace rakelight {

std::string file_ending(std::string_view path) {
    const std::string_view name = path.substr(path.find_last_of('/') + 1);  // npos + 1 is 0
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos || dot == 0) return {};
    return lower_case(name.substr(dot + 1));
}

}  // namespace rakelight
