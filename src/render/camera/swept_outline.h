// SPDX-License-Identifier: Apache-2.0
// The space that a model sweeps during a full turn about an axis, as a scene of a few points that cameras are fitted
// to.
#pragma once
#include <span>

#include <rakelight/scene/scene.h>
#include <rakelight/scene/scene_queries.h>

namespace rakelight {

/// Rings about the axis, through the places that reach farthest in 32 directions beside it: what lies between these reaches 0.5 %
/// farther out at most.
/// @param outlines  nothing in them moves; each counts
/// @param box  about all that is drawn of them, not empty: its center lies on the axis, and vertices outside of it do not count
/// @param axis  of length 1
Scene swept_outline(std::span<const Scene> outlines, const Bounds& box, dvec3 axis);

}  // namespace rakelight
