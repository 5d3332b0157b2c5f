// SPDX-License-Identifier: Apache-2.0
// Selects the clips of a picture.
#include <algorithm>
#include <string>
#include <string_view>

#include <rakelight/base/error.h>
#include <rakelight/scene/words.h>
#include <rakelight/world/request.h>

#include "base/format_text.h"

namespace rakelight {
namespace {

constexpr std::size_t max_listed = 6, max_alike = 6;

/// "0 'walk', 1 'run'"
std::string list_of(const Scene& scene) {
    std::string text;
    for (std::size_t i = 0; i < scene.animations.size() && i < max_listed; ++i)
        text += format_text("{}{} '{}'", i > 0 ? ", " : "", i, one_line(scene.animations[i].name, 30));
    return scene.animations.size() > max_listed ? text + ", ..." : text;
}

/// Clips with a similar name, else all clips.
std::string advice_for(const Scene& scene, const std::string& name) {
    std::vector<std::string_view> names;
    std::string alike;
    std::size_t count = 0;
    for (const Animation& animation : scene.animations) {
        names.push_back(animation.name);
        const bool begins =
            animation.name.size() > name.size() && same_word(animation.name.substr(0, name.size()), name);
        if (begins && ++count <= max_alike) alike += (alike.empty() ? "'" : ", '") + one_line(animation.name, 40) + "'";
    }
    if (!alike.empty()) return "there are " + alike + (count > max_alike ? ", ..." : "");
    if (const std::string nearest = nearest_word(name, names); !nearest.empty())
        return "did you mean '" + one_line(nearest, 40) + "'?";
    return "the scene has " + list_of(scene) + "; inspect lists them all";
}

std::uint32_t clip_named(const Scene& scene, const std::string& name) {
    std::vector<std::string_view> names;
    for (const Animation& animation : scene.animations) names.push_back(animation.name);
    if (const auto same = std::ranges::find(names, name); same != names.end())
        return std::uint32_t(same - names.begin());
    // Case is ignored if the match is unique.
    const auto is_meant = [&](std::string_view other) { return same_word(other, name); };
    if (std::ranges::count_if(names, is_meant) == 1)
        return std::uint32_t(std::ranges::find_if(names, is_meant) - names.begin());
    throw Error(ErrorCode::usage, "there is no animation '" + one_line(name, 40) + "'", {}, advice_for(scene, name))
        .about("animation-name", {"animation-index"});
}

bool is_of_world(const Animation& animation) { return animation.plays_always; }

/// The requested clips; by default the first that is not the world's own.
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
                    format_text("there is no animation {}; the scene has {}", *motion.index, list_of(scene)))
            .about("animation-index", {"animation-name"});
    return {std::uint32_t(*motion.index)};
}

}  // namespace

std::vector<ClipTime> clips_of(const Scene& scene, const MotionRequest& motion) {
    if (!motion.is_set()) return {};
    const std::size_t count = scene.animations.size();
    if (count == 0) {
        if (motion.autoplay && !motion.index && motion.name.empty() && !motion.time_s) return {};
        throw Error(ErrorCode::usage, "the scene has no animations")
            .about(motion.index           ? "animation-index"
                   : !motion.name.empty() ? "animation-name"
                                          : "animation-time",
                   {"animation-time"});
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
