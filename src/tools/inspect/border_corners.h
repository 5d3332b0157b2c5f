// SPDX-License-Identifier: Apache-2.0
// The corners at places that several parts draw.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/faults/place_classes.h"
#include "tools/inspect/seam_normals.h"

namespace rakelight {

/// Corners of one part that have the same normals before and after are one.
struct BorderCorner {
    std::uint32_t place, part;
    std::uint32_t before, after;  ///< vertices of the part's normals
    auto operator<=>(const BorderCorner&) const = default;
};

/// Sorted by place, then part; only corners of faces that are any (geometry::face_places)
/// and that are no needles.
std::vector<BorderCorner> find_border_corners(const geometry::PlacedMeshes& placed, const SeamNormals& normals,
                                              Context& context);

}  // namespace rakelight
