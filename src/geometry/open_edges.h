// SPDX-License-Identifier: Apache-2.0
// Edges of one face in the whole model, in a pass over the faces and a sort of the few that can be open.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/place_classes.h"

namespace rakelight::geometry {

/// @return the corner where each open edge begins, as its face's indices go round; ascending. Faces without three places are
///         left out (face_places()). The edges of EdgeCensus::open_corners. 8 bytes per vertex; expected O(n).
std::vector<std::uint32_t> find_open_edges(const PlacedMeshes& placed, Context& context);

}  // namespace rakelight::geometry
