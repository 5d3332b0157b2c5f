// SPDX-License-Identifier: Apache-2.0
// The Utah teapot, tessellated.
#pragma once
#include <rakelight/base/memory_budget.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// The Utah teapot from Newell's 32 Bezier patches, as six objects (rim, body, handle, spout, lid, bottom) with their
/// patch u, v; no normals (prepare_scene() computes them). `divisions` quads per side of each patch, 1..256.
/// @param memory charged for the arrays before they are created; may be null. Border positions of adjacent patches are
///         bit-equal
Scene make_teapot(int divisions = 10, MemoryBudget* memory = nullptr);
/// The divisions for which facets are within `tolerance` [m], > 0, of the patch at equal u, v.
/// @throws Error usage: more than 256 would be needed
int teapot_divisions(double tolerance);

}  // namespace rakelight
