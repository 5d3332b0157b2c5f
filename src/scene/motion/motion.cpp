// SPDX-License-Identifier: Apache-2.0
// Evaluates clips at a moment: transforms and morph weights into Scene::pose, other properties into their objects.
#include <rakelight/scene/motion.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

#include <rakelight/base/error.h>
#include <rakelight/scene/animated_properties.h>

#include "base/format_text.h"
#include "math/linear.h"
#include "scene/motion/animated_properties.h"
#include "scene/motion/motion.h"
#include "scene/motion/sample_channel.h"
#include "scene/validate_parts.h"

namespace rakelight {
namespace {

/// The rotation of an orthonormal basis (Shepperd 1978, "Quaternion from Rotation Matrix": the largest of four first).
dquat rotation_of(dvec3 x, dvec3 y, dvec3 z) {
    const double trace = x.x + y.y + z.z;
    const auto root = [](double v) { return std::sqrt(std::max(v, 0.0)) / 2; };
    if (trace >= std::max({x.x, y.y, z.z})) {
        const double w = root(1 + trace);
        return {(y.z - z.y) / (4 * w), (z.x - x.z) / (4 * w), (x.y - y.x) / (4 * w), w};
    }
    if (x.x >= std::max(y.y, z.z)) {
        const double q = root(1 + x.x - y.y - z.z);
        return {q, (x.y + y.x) / (4 * q), (x.z + z.x) / (4 * q), (y.z - z.y) / (4 * q)};
    }
    if (y.y >= z.z) {
        const double q = root(1 + y.y - x.x - z.z);
        return {(x.y + y.x) / (4 * q), q, (y.z + z.y) / (4 * q), (z.x - x.z) / (4 * q)};
    }
    const double q = root(1 + z.z - x.x - y.y);
    return {(z.x + x.z) / (4 * q), (z.y + y.z) / (4 * q), q, (x.y - y.x) / (4 * q)};
}

/// Decomposes a matrix into the parts that channels animate; shear is lost.
Transform in_parts(const Transform& t) {
    if (!t.matrix) return t;
    const dmat4& m = *t.matrix;
    dvec3 x = m[0].xyz(), y = m[1].xyz(), z = m[2].xyz();
    const double side = determinant(upper_left(m)) < 0 ? -1 : 1;
    Transform parts;
    parts.translation = m[3].xyz();
    parts.scale = {side * length(x), length(y), length(z)};
    x = normalize_or(x * side, dvec3{1, 0, 0});
    y = normalize_or(y - x * dot(x, y), dvec3{0, 1, 0});
    parts.rotation = rotation_of(x, y, cross(x, y));
    return parts;
}

void move_node(const AnimationChannel& channel, std::span<const float> v, ScenePose& pose) {
    Transform& t = pose.local[channel.element];
    t = in_parts(t);
    if (channel.path == AnimationPath::translation)
        t.translation = {v[0], v[1], v[2]};
    else if (channel.path == AnimationPath::rotation)
        t.rotation = {v[0], v[1], v[2], v[3]};
    else
        t.scale = {v[0], v[1], v[2]};
}

/// Morph weights of a clip at a moment. Channels of the same keys share them.
class SampledWeights {
public:
    explicit SampledWeights(MemoryBudget& memory) : memory_(memory) {}
    /// @throws Error bad_file: over the memory budget
    Block<float> at(const AnimationChannel& channel, double time_s, std::size_t width) {
        Block<float>& known =
            sampled_[{channel.times.identity(), channel.values.identity(), channel.interpolation, width}];
        if (!known.empty()) return known;
        MemoryCharge charge(memory_, width * sizeof(float), "morph weights");
        std::vector<float> values(width);
        sample_channel(channel, time_s, values);
        return known = {std::move(values), std::move(charge)};
    }

private:
    MemoryBudget& memory_;
    std::map<std::tuple<const void*, const void*, Interpolation, std::size_t>, Block<float>> sampled_;
};

void apply(const Animation& animation, double time_s, MemoryBudget& memory, Scene& scene, ScenePose& pose) {
    std::vector<float> values;
    SampledWeights weights(memory);
    for (const AnimationChannel& channel : animation.channels) {
        if (channel.element == no_index || channel.times.empty()) continue;
        const std::size_t width = channel_width(scene, channel);
        if (width == 0) continue;
        if (channel.path == AnimationPath::morph_weights) {
            pose.morph_weights[channel.element] = weights.at(channel, time_s, width);
            continue;
        }
        values.resize(width);
        sample_channel(channel, time_s, values);
        if (channel.is_of_node())
            move_node(channel, values, pose);
        else
            set_property(scene, *animated_property(channel.path, channel.property), channel.element, values);
    }
}

/// The lights and cameras that a clip moves.
void settle(const Animation& animation, const std::vector<Camera>& before, Scene& scene) {
    for (const AnimationChannel& channel : animation.channels) {
        if (channel.element == no_index) continue;
        if (channel.path == AnimationPath::light) settle(scene.lights[channel.element]);
        if (channel.path == AnimationPath::camera) settle(scene.cameras[channel.element], before[channel.element]);
    }
}

}  // namespace

ClipSpan clip_span(const Animation& animation) {
    double begin = std::numeric_limits<double>::infinity(), end = -begin;
    for (const AnimationChannel& channel : animation.channels) {
        if (channel.times.empty()) continue;
        begin = std::min(begin, double(channel.times[0]));
        end = std::max(end, double(channel.times[channel.times.size() - 1]));
    }
    return begin <= end ? ClipSpan{begin, end} : ClipSpan{};
}

ScenePose rest_pose(const Scene& scene) {
    ScenePose pose;
    pose.local.reserve(scene.nodes.size()), pose.morph_weights.reserve(scene.nodes.size());
    for (const Node& node : scene.nodes) {
        pose.local.push_back(node.local);
        pose.morph_weights.push_back(node.morph_weights);
    }
    return pose;
}

void check_clips(const Scene& scene, std::span<const ClipTime> clips) {
    for (const ClipTime& clip : clips) {
        if (clip.animation >= scene.animations.size())
            throw Error(ErrorCode::usage, format_text("there is no animation {}: the scene has {}", clip.animation,
                                                      scene.animations.size()));
        if (!std::isfinite(clip.time_s)) throw Error(ErrorCode::usage, "the time of an animation is not a number");
    }
}

Scene scene_at(Scene scene, std::span<const ClipTime> clips) {
    MemoryBudget own;  // its account lives as long as what is charged to it
    return scene_at(std::move(scene), clips, own);
}

Scene scene_at(Scene still, const std::vector<Animation>& animations, std::span<const ClipTime> clips,
               MemoryBudget& memory) {
    std::vector<ClipTime> own(clips.begin(), clips.end());
    for (ClipTime& clip : own) {
        if (clip.animation >= animations.size())
            throw Error(ErrorCode::usage,
                        format_text("there is no animation {}: the scene has {}", clip.animation, animations.size()));
        still.animations.push_back(animations[clip.animation]);
        clip.animation = std::uint32_t(still.animations.size() - 1);
    }
    return scene_at(std::move(still), own, memory);
}

Scene scene_at(Scene scene, std::span<const ClipTime> clips, MemoryBudget& memory) {
    check_clips(scene, clips);
    for (const ClipTime& clip : clips) check_animation(scene, clip.animation);
    if (clips.empty()) return scene;
    ScenePose pose = scene.pose ? *scene.pose : rest_pose(scene);
    const std::vector<Camera> before = scene.cameras;
    for (const ClipTime& clip : clips) {
        const Animation animation = scene.animations[clip.animation];  // arrays are shared
        apply(animation, clip.time_s, memory, scene, pose);
    }
    for (const ClipTime& clip : clips) settle(scene.animations[clip.animation], before, scene);
    scene.pose = pose;
    return scene;
}

}  // namespace rakelight
