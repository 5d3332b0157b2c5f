// SPDX-License-Identifier: Apache-2.0
// Open edges (with one face in the whole model), by one pass over the faces and a sort of the few candidates.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/faults/place_classes.h"

namespace rakelight::geometry {

/// @return the corner where each open edge starts in the winding of its face; ascending. Faces without three different
///         places are skipped (face_places()). The edges of EdgeCensus::open_corners. 8 bytes per vertex; expected
///         O(n).
std::vector<std::uint32_t> find_open_edges(const PlacedMeshes& placed, Context& context);

}  // namespace rakelight::geometry
