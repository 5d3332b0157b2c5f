// SPDX-License-Identifier: Apache-2.0
// The charts that texture coordinates are made of, as they are found: triangles that share an edge on the surface and on the map.
#pragma once
#include <cstdint>
#include <vector>

#include "bake/low_surface.h"

namespace rakelight::bake {

/// A triangle on the map.
struct MapTriangle {
    dvec2 at[3]{};             ///< [px] its lowest corner in the map, others may reach beyond
    bool is_mirrored = false;  ///< as seen from outside
};

struct MapCharts {
    std::vector<std::uint32_t> of_triangle{};  ///< [T]
    std::vector<std::uint8_t> is_mirrored{};   ///< [charts] most of its triangles are
};

/// Repeating maps: moved by whole maps to where the map is. A corner that is not finite or too far out is 0.
MapTriangle on_map(const LowSurface& low, std::uint32_t triangle, int width, int height);

MapCharts find_map_charts(const LowSurface& low, Context& context);

}  // namespace rakelight::bake
