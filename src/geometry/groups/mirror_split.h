// SPDX-License-Identifier: Apache-2.0
// Texture coordinates that lie mirrored on both sides of a vertex need two tangents: such a vertex is doubled.
#pragma once
#include "geometry/corners/topology.h"

namespace rakelight::geometry {

/// Vertices with faces of both handednesses keep the right-handed ones; the left-handed get an appended vertex of the same
/// normal group. Faces without texture area stay where they are.
/// @param keep_normals  handedness is seen from the given normals, not from the faces' own
void split_mirrored(Topology& topology, const AttributeInput& input, bool keep_normals, Context& context);

}  // namespace rakelight::geometry
