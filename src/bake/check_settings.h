// SPDX-License-Identifier: Apache-2.0
// Checks of settings shared by baking and lightmaps.
#pragma once
#include <algorithm>
#include <string>
#include <utility>

#include <rakelight/base/error.h>

namespace rakelight::bake {

/// @throws Error usage
inline void require(bool is_right, const char* setting, std::string reason) {
    if (!is_right) throw Error(ErrorCode::usage, std::move(reason)).about(setting);
}

/// Size, samples, padding and margin: of BakeOptions or LightmapOptions. @throws Error usage
template <class Options>
void check_map(const Options& o) {
    constexpr int max_pixels = 16384;  // side
    require(std::min(o.width, o.height) >= 1 && std::max(o.width, o.height) <= max_pixels, "size",
            "must be 1 to 16384 pixels a side");
    require(o.samples == 1 || o.samples == 4 || o.samples == 16, "samples", "must be 1, 4 or 16 a texel");
    require(o.padding >= 0 && o.padding <= 1024, "padding", "must be 0 to 1024 pixels");
    require(o.chart_margin >= 1 && o.chart_margin <= 1024, "chart-margin", "must be 1 to 1024 pixels");
}

}  // namespace rakelight::bake
