// SPDX-License-Identifier: Apache-2.0
// The keys of a world's cameras and lights as a clip of its scene.
#pragma once
#include <rakelight/world.h>

namespace rakelight {

/// Tracks as channels, `world_clip_name`; those of cameras and lights that are not there are left out.
/// Smooth ones become cubic splines whose tangents are the slope of the parabola through a key and its two neighbors, at the ends
/// that of the parabola of the first or last three keys there (Catmull and Rom 1974 for any times; de Boor 1978, "A Practical Guide
/// to Splines", chapter IV: Bessel's). So keys of uniform motion stay uniform, and those of a parabola lie on it.
/// Two keys: a straight line.
Animation world_clip(const WorldFile& world);

}  // namespace rakelight
