// SPDX-License-Identifier: Apache-2.0
// Finds the charts of existing texture coordinates: triangles that share an edge on the surface and on the map.
#pragma once
#include <cstdint>
#include <vector>

#include "bake/low/low_surface.h"

namespace rakelight::bake {

/// A triangle on the map.
struct MapTriangle {
    dvec2 at[3]{};             ///< [px] its lowest corner is inside the map, others may be outside
    bool is_mirrored = false;  ///< as seen from outside
};

struct MapCharts {
    std::vector<std::uint32_t> of_triangle{};  ///< [T]
    std::vector<std::uint8_t> is_mirrored{};   ///< [charts] by the majority of its triangles
};

/// Repeating maps: triangles are shifted by whole maps into the map. Non-finite and too distant corners become 0.
MapTriangle on_map(const LowSurface& low, std::uint32_t triangle, int width, int height);

MapCharts find_map_charts(const LowSurface& low, Context& context);

}  // namespace rakelight::bake
