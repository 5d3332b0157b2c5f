// SPDX-License-Identifier: Apache-2.0
// Polygons as tests write them.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/refine/surface_pieces.h"

namespace rakelight::geometry::test {

using Faces = std::vector<std::vector<std::uint32_t>>;

inline Polygons polygons(const Faces& faces) {
    Polygons out;
    for (const auto& face : faces) {
        out.corners.insert(out.corners.end(), face.begin(), face.end());
        out.end_face();
    }
    return out;
}

}  // namespace rakelight::geometry::test
