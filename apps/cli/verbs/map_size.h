// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include <rakelight/world/values.h>

namespace rakelight::cli {

/// "1024", or "2048,1024": [1 or 2] of a picture that is a map. @throws Error usage
inline std::vector<int> map_size(const char* option, const std::string& text) {
    std::vector<int> size = values::integers(option, text, text.find_first_of(",x") == std::string::npos ? 1 : 2);
    for (const int side : size)
        if (side < 1 || side > 16384) throw values::wrong(option, "must be 1 to 16384 pixels per side");
    return size;
}

}  // namespace rakelight::cli
