// SPDX-License-Identifier: Apache-2.0
// Which clips a picture shows.
#include <algorithm>
#include <string>

#include <rakelight/error.h>
#include <rakelight/request.h>

#include "scene/scene_tools.h"

namespace rakelight {
namespace {

constexpr std::size_t most_listed = 12;

/// "0 'walk', 1 'run'"
std::string list_of(const Scene& scene) {
    std::string text;
    for (std::size_t i = 0; i < scene.animations.size() && i < most_listed; ++i)
        text += (i > 0 ? ", " : "") + std::to_string(i) + " '" + one_line(scene.animations[i].name, 30) + "'";
    return scene.animations.size() > most_listed ? text + ", ..." : text;
}

std::uint32_t clip_named(const Scene& scene, const std::string& name) {
    for (std::uint32_t i = 0; i < scene.animations.size(); ++i)
        if (scene.animations[i].name == name) return i;
    throw Error(ErrorCode::usage, "there is no animation of that name; the scene has " + list_of(scene))
        .about("animation-name", {"animation-index"});
}

bool is_of_world(const Animation& animation) { return animation.name == world_clip_name; }

/// The clips that are asked for. The first that is not the world's own where nothing says which.
std::vector<std::uint32_t> chosen(const Scene& scene, const MotionRequest& motion) {
    const auto count = std::uint32_t(scene.animations.size());
    if (!motion.name.empty()) return {clip_named(scene, motion.name)};
    std::vector<std::uint32_t> clips;
    if (motion.index == -1) {
        for (std::uint32_t i = 0; i < count; ++i) clips.push_back(i);
        return clips;
    }
    if (!motion.index) {
        const auto first = std::ranges::find_if_not(scene.animations, is_of_world);
        return {first == scene.animations.end() ? 0 : std::uint32_t(first - scene.animations.begin())};
    }
    if (std::size_t(*motion.index) >= count)
        throw Error(ErrorCode::usage,
                    "there is no animation " + std::to_string(*motion.index) + "; the scene has " + list_of(scene))
            .about("animation-index", {"animation-name"});
    return {std::uint32_t(*motion.index)};
}

}  // namespace

std::vector<ClipTime> clips_of(const Scene& scene, const MotionRequest& motion) {
    if (!motion.asks()) return {};
    const std::size_t count = scene.animations.size();
    if (count == 0) {
        if (motion.autoplay && !motion.index && motion.name.empty() && !motion.time_s) return {};
        throw Error(ErrorCode::usage, "the scene has no animations").about("animation-time", {"animation-time"});
    }
    std::vector<ClipTime> times;
    for (const std::uint32_t clip : chosen(scene, motion))
        times.push_back({clip, motion.time_s.value_or(clip_span(scene.animations[clip]).begin_s)});
    for (std::uint32_t i = 0; i < count; ++i)
        if (is_of_world(scene.animations[i]) && std::ranges::find(times, i, &ClipTime::animation) == times.end())
            times.push_back({i, times[0].time_s});
    return times;
}

}  // namespace rakelight
