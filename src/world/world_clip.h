// SPDX-License-Identifier: Apache-2.0
// Converts the keys of a world's cameras and lights to a clip.
#pragma once
#include <rakelight/io/world.h>

namespace rakelight {

/// Tracks as channels of the clip `world_clip_name`; tracks of missing cameras and lights are skipped. Smooth tracks
/// become cubic splines. Their tangents are the slope of the parabola through a key and its two neighbors, at the ends
/// through the first or last three keys. This is Catmull and Rom 1974 for any times (de Boor 1978, "A Practical Guide
/// to Splines", chapter IV: Bessel). Uniform motion and parabolas are reproduced exactly. Two keys: a straight line.
Animation world_clip(const WorldFile& world);

}  // namespace rakelight
