// SPDX-License-Identifier: Apache-2.0
// One channel of a clip at a moment.
#pragma once
#include <cstddef>
#include <span>

#include <rakelight/scene/scene.h>

namespace rakelight {

/// Numbers that a key of the channel of a valid scene holds: those of its path, of morph weights the targets of the node's
/// meshes.
std::size_t channel_width(const Scene& scene, const AnimationChannel& channel);

/// glTF 2.0, appendix C. Clamped to the first and last key. Rotations are unit: linear ones along the shorter arc
/// (Shoemake 1985, "Animating Rotation with Quaternion Curves"), splines normalized.
/// @param channel  with keys, of a valid scene
/// @param out  [width]
void sample_channel(const AnimationChannel& channel, double time_s, std::span<float> out);

}  // namespace rakelight
