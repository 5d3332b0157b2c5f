// SPDX-License-Identifier: Apache-2.0
// Scenes that move: clips at a moment. What skins and morph targets make of the vertices then: posed_scene() in
// <rakelight/prepare.h>.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include <rakelight/export.h>
#include <rakelight/scene.h>

namespace rakelight {

/// A clip at a moment.
struct ClipTime {
    std::uint32_t animation = 0;  ///< into Scene::animations
    double time_s = 0;            ///< [s] finite; before the first and after the last key of a channel: that key
    bool operator==(const ClipTime&) const = default;
};

/// [s] From the first to the last key of a clip; 0 to 0 for one that has no keys.
struct ClipSpan {
    double begin_s = 0, end_s = 0;  ///< [s]
    /// [s]
    double length() const { return end_s - begin_s; }
};
/// From the first to the last key of all channels.
RL_API ClipSpan clip_span(const Animation& animation);

/// The scene with its clips at a moment: Scene::pose says where nodes and morph weights are then; numbers of materials,
/// lights and cameras are replaced. Without clips: the scene as its file has it, pose or none.
/// Interpolation as glTF 2.0, appendix C: step, linear (rotations along the shorter arc), cubic Hermite splines. Of
/// several clips that move one thing the last counts. Meshes are shared: costs what the channels do.
/// @throws Error usage: no such clip, a time that is not finite; bad_file: see validate()
RL_API Scene scene_at(Scene scene, std::span<const ClipTime> clips);

/// The clip of a world's own keys, the last of its scene. Animation::goes_with_all marks it.
inline constexpr std::string_view world_clip_name = "world";

/// What channels of materials, lights and cameras can move.
struct AnimatedProperty {
    AnimationPath path;
    std::string_view name;  ///< AnimationChannel::property
    std::uint32_t width;    ///< numbers a key: 1..4
};
/// All properties that a channel can move.
RL_API std::span<const AnimatedProperty> animated_properties();
/// The row of that name; null: there is none.
RL_API const AnimatedProperty* animated_property(AnimationPath path, std::string_view name);

}  // namespace rakelight
