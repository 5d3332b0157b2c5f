// SPDX-License-Identifier: Apache-2.0
// Closed bodies, of however many meshes, whose faces all look inwards.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/place_classes.h"

namespace rakelight::geometry {

/// A body: faces that are connected over places, whichever mesh or object they belong to.
struct InsideOutBody {
    std::uint32_t triangles = 0;
    std::vector<std::uint32_t> objects;  ///< that have a part in it, ascending
};

/// Bodies without an open edge that enclose a volume which is negative by the winding of their faces (the divergence
/// theorem; Zhang & Chen 2001, "Efficient Feature Extraction for 2D/3D Objects in Mesh Representation"). Left out are:
/// bodies whose faces are not all wound one way (the sum of their area vectors is not 0: then the volume depends on the
/// origin), thin ones (two sheets back to back), and those that lie in the bounding box of another closed body: the
/// inner side of a hollow one looks inwards rightly. In the order of their smallest place, at most 1000. O(n log n),
/// but for the boxes: O(inside out bodies times closed bodies), at most 30 million pairs; of bodies beyond nothing is
/// reported.
/// @param open_corners  EdgeCensus::open_corners
std::vector<InsideOutBody> find_inside_out(const PlacedMeshes& placed, std::span<const std::uint32_t> open_corners,
                                           const Context& context);

}  // namespace rakelight::geometry
