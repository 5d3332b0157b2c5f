// SPDX-License-Identifier: Apache-2.0
// Closed bodies of any number of meshes with all faces oriented inwards.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/faults/place_classes.h"

namespace rakelight::geometry {

/// A body: faces connected over places, of any meshes and objects.
struct InsideOutBody {
    std::uint32_t triangles = 0;
    std::vector<std::uint32_t> objects;  ///< objects of the body, ascending
};

/// Bodies without open edges and with negative signed volume (divergence theorem; Zhang & Chen 2001, "Efficient Feature
/// Extraction for 2D/3D Objects in Mesh Representation"). Excluded are inconsistently oriented bodies (nonzero sum of
/// area vectors, so the volume depends on the origin) and thin ones (two sheets back to back). Bodies in the bounding
/// box of another closed body are excluded too, because inner surfaces of hollow bodies face inwards. In the order of
/// their smallest place, at most 1000. O(n log n), plus at most 30 million box tests; bodies beyond that are not
/// reported.
/// @param open_corners  EdgeCensus::open_corners
std::vector<InsideOutBody> find_inside_out(const PlacedMeshes& placed, std::span<const std::uint32_t> open_corners,
                                           const Context& context);

}  // namespace rakelight::geometry
