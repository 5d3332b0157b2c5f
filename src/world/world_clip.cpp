// SPDX-License-Identifier: Apache-2.0
#include "world/world_clip.h"

#include <rakelight/scene/animated_properties.h>
#include <rakelight/scene/motion.h>

#include <algorithm>
#include <limits>
#include <string>

namespace rakelight {
namespace {

using Between = WorldTrack::Between;

/// One component of a track over its keys.
struct Curve {
    const WorldTrack& track;
    std::size_t width, number;

    double value(std::size_t k) const { return track.values[k * width + number]; }
    /// From key k to the next.
    double seconds(std::size_t k) const { return double(track.times[k + 1]) - track.times[k]; }
    double slope(std::size_t k) const { return (value(k + 1) - value(k)) / seconds(k); }

    /// Slope of the parabola through the keys k - 1, k and k + 1.
    double middle_tangent(std::size_t k) const {
        const double before = seconds(k - 1), behind = seconds(k);
        return (behind * slope(k - 1) + before * slope(k)) / (before + behind);
    }
    /// @pre at least three keys
    double tangent(std::size_t k) const {
        const std::size_t last = track.times.size() - 1;
        if (k == 0) return 2 * slope(0) - middle_tangent(1);
        if (k == last) return 2 * slope(last - 1) - middle_tangent(last - 1);
        return middle_tangent(k);
    }
};

/// In-tangent, value and out-tangent of every key.
std::vector<float> spline_values(const WorldTrack& track, std::size_t width) {
    constexpr double most = std::numeric_limits<float>::max();
    std::vector<float> values;
    values.reserve(3 * track.values.size());
    for (std::size_t k = 0; k < track.times.size(); ++k) {
        std::vector<float> tangents;
        for (std::size_t i = 0; i < width; ++i)
            tangents.push_back(float(std::clamp(Curve{track, width, i}.tangent(k), -most, most)));
        values.insert(values.end(), tangents.begin(), tangents.end());
        for (std::size_t i = 0; i < width; ++i) values.push_back(track.values[k * width + i]);
        values.insert(values.end(), tangents.begin(), tangents.end());
    }
    return values;
}

AnimationChannel channel_of(const WorldTrack& track, std::size_t width) {
    AnimationChannel channel;
    channel.element = track.element, channel.path = track.path, channel.property = track.property;
    channel.times = track.times;
    const bool is_spline = track.between == Between::smooth && track.times.size() > 2;
    channel.interpolation = is_spline                        ? Interpolation::cubic_spline
                            : track.between == Between::step ? Interpolation::step
                                                             : Interpolation::linear;
    channel.values = is_spline ? spline_values(track, width) : track.values;
    return channel;
}

}  // namespace

Animation world_clip(const WorldFile& world) {
    Animation clip;
    clip.name = world_clip_name, clip.plays_always = true;
    for (const WorldTrack& track : world.tracks) {
        const std::size_t count = track.path == AnimationPath::camera ? world.cameras.size() : world.lights.size();
        const AnimatedProperty* const property = animated_property(track.path, track.property);
        if (!property || track.element >= count || track.values.size() != track.times.size() * property->width)
            continue;
        clip.channels.push_back(channel_of(track, property->width));
    }
    return clip;
}

}  // namespace rakelight
