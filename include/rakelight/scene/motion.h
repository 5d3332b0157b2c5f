// SPDX-License-Identifier: Apache-2.0
// Animation: the scene at a given time of its clips. For skinning and morphing of vertices see posed_scene() in
// <rakelight/prepare/prepare.h>.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include <rakelight/base/export.h>
#include <rakelight/base/memory_budget.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// A moment of a clip.
struct ClipTime {
    std::uint32_t animation = 0;  ///< into Scene::animations
    double time_s = 0;            ///< [s] finite; each channel clamps it to the times of its first and last key
    bool operator==(const ClipTime&) const = default;
};

/// The time range of a clip. Without keys both times are 0.
struct ClipSpan {
    double begin_s = 0, end_s = 0;  ///< [s]
    /// [s] duration
    double length() const { return end_s - begin_s; }
};
/// The time range from the first to the last key of all channels.
RL_API ClipSpan clip_span(const Animation& animation);

/// The scene at a moment of its clips. Scene::pose gets the transforms and morph weights. Animated properties of
/// materials, lights and cameras are replaced. If `clips` is empty, the result is the scene as in its file.
/// Interpolation as in glTF 2.0, appendix C: step, linear (rotations along the shorter arc), or cubic Hermite splines.
/// If several clips animate one property, the last clip applies. Meshes are shared; the cost depends on the number of
/// channels only.
/// Morph weights are charged to a budget of their own with the default limit.
/// @throws Error usage: no such clip, a non-finite time; bad_file: see validate(), over the memory budget
RL_API Scene scene_at(Scene scene, std::span<const ClipTime> clips);
/// The same.
/// @param memory  that morph weights are charged to
RL_API Scene scene_at(Scene scene, std::span<const ClipTime> clips, MemoryBudget& memory);
/// The same for a scene without its clips, which are these. The result has the clips that are shown alone: of a character
/// with a hundred clips a copy of all takes as long as its pose.
RL_API Scene scene_at(Scene still, const std::vector<Animation>& animations, std::span<const ClipTime> clips,
                      MemoryBudget& memory);

/// The name of the clip that holds the keyframes of a world file. It is the last clip of the scene, and has
/// Animation::plays_always.
inline constexpr std::string_view world_clip_name = "world";

}  // namespace rakelight
