// SPDX-License-Identifier: Apache-2.0
#include "recorded_keys.h"

#include <algorithm>
#include <cmath>

#include <rakelight/math/linear.h>

namespace rakelight::viewer {
namespace {

bool is_same_moment(double a, double b) { return std::fabs(a - b) < same_moment_s; }

/// But for what rounding makes of a camera that default lights stand with.
bool are_close(dvec3 a, dvec3 b) { return length(a - b) <= 1e-9 * (1 + length(a)); }

template <class Key>
void put(std::vector<Key>& keys, Key key) {
    std::erase_if(keys, [&](const Key& k) { return is_same_moment(k.time_s, key.time_s); });
    const auto at = std::ranges::upper_bound(keys, key.time_s, {}, &Key::time_s);
    keys.insert(at, std::move(key));
}

template <class Key>
std::size_t take(std::vector<Key>& keys, double time_s) {
    return std::erase_if(keys, [&](const Key& k) { return is_same_moment(k.time_s, time_s); });
}

/// A channel of places or directions, or of single numbers where `read` gives those.
template <class Key, class Read>
AnimationChannel channel_of(const std::vector<Key>& keys, AnimationPath path, std::uint32_t element,
                            const char* property, const Read& read) {
    AnimationChannel channel{.element = element, .path = path, .property = property};
    std::vector<float> times, values;
    for (const Key& key : keys) {
        times.push_back(float(key.time_s));
        if constexpr (std::is_same_v<decltype(read(key)), double>) {
            values.push_back(float(read(key)));
        } else {
            const dvec3 v = read(key);
            values.insert(values.end(), {float(v.x), float(v.y), float(v.z)});
        }
    }
    channel.times = std::move(times), channel.values = std::move(values);
    return channel;
}

AnimationChannel targets_of(const std::vector<EyeKey>& keys, AnimationPath path, std::uint32_t element,
                            const char* property) {
    return channel_of(keys, path, element, property, [](const EyeKey& k) { return k.eye.focal; });
}

/// The last one before a moment, or the first of all.
const Eye& eye_before(const std::vector<EyeKey>& keys, double time_s) {
    const auto next = std::ranges::upper_bound(keys, time_s + same_moment_s, {}, &EyeKey::time_s);
    return next == keys.begin() ? keys.front().eye : std::prev(next)->eye;
}

}  // namespace

Camera level_camera(dvec3 world_up) {
    const dvec3 other = std::fabs(world_up.y) < 0.9 ? dvec3{0, 1, 0} : dvec3{0, 0, 1};
    Camera camera;
    camera.to_world = look_at({0, 0, 0}, cross(world_up, other), world_up);
    return camera;
}

void set_key(Look& look, const Model& model, int width, int height, double time_s) {
    put(look.keys, {time_s, moving_eye(look, model, width, height)});
    if (!look.lights) return;
    Look unmoved = look;
    unmoved.lights.reset();
    const std::vector<LightItem> own = changing_lights(unmoved, model, width, height);
    for (std::size_t i = 0; i < look.lights->size(); ++i) {
        LightItem& item = (*look.lights)[i];
        const Light& light = item.light;
        const bool is_unmoved = i < own.size() && are_close(own[i].light.position, light.position) &&
                                are_close(own[i].light.direction, light.direction);
        if (!is_unmoved || !item.keys.empty()) put(item.keys, {time_s, light.position, light.direction});
    }
}

bool delete_key(Look& look, double time_s) {
    std::size_t count = take(look.keys, time_s);
    if (look.lights)
        for (LightItem& item : *look.lights) count += take(item.keys, time_s);
    return count > 0;
}

std::vector<double> key_times(const Look& look) {
    std::vector<double> times;
    for (const EyeKey& key : look.keys) times.push_back(key.time_s);
    if (look.lights)
        for (const LightItem& item : *look.lights)
            for (const LightKey& key : item.keys) times.push_back(key.time_s);
    std::ranges::sort(times);
    const auto rest = std::ranges::unique(times, is_same_moment);
    times.erase(rest.begin(), rest.end());
    return times;
}

Animation animation_of_keys(const Look& look) {
    Animation animation{.name = "keys"};
    auto& channels = animation.channels;
    if (!look.keys.empty()) {
        const AnimationPath path = AnimationPath::camera;
        channels.push_back(channel_of(look.keys, path, 0, "position", [](const EyeKey& k) { return k.eye.position; }));
        channels.push_back(targets_of(look.keys, path, 0, "target"));
        channels.push_back(
            channel_of(look.keys, path, 0, "vertical_fov", [](const EyeKey& k) { return radians(k.eye.fov_deg); }));
    }
    const std::size_t lights = look.lights ? look.lights->size() : 0;
    for (std::uint32_t i = 0; i < lights; ++i) {
        const std::vector<LightKey>& keys = (*look.lights)[i].keys;
        if (keys.empty()) continue;
        const AnimationPath path = AnimationPath::light;
        channels.push_back(channel_of(keys, path, i, "position", [](const LightKey& k) { return k.position; }));
        channels.push_back(channel_of(keys, path, i, "direction", [](const LightKey& k) { return k.direction; }));
    }
    return animation;
}

void follow_keys(Look& look, double time_s) {
    Scene scene;
    scene.animations = {animation_of_keys(look)};
    if (scene.animations[0].channels.empty()) return;
    scene.cameras = {level_camera(look.world_up)};
    const std::size_t count = look.lights ? look.lights->size() : 0;
    for (std::size_t i = 0; i < count; ++i) scene.lights.push_back((*look.lights)[i].light);
    scene.lights.emplace_back();  // stands where the eye looks
    if (!look.keys.empty())
        scene.animations[0].channels.push_back(
            targets_of(look.keys, AnimationPath::light, std::uint32_t(count), "position"));
    const ClipTime now{0, time_s};
    scene = scene_at(std::move(scene), {&now, 1});
    for (std::size_t i = 0; i < count; ++i)
        if (!(*look.lights)[i].keys.empty()) {
            (*look.lights)[i].light.position = scene.lights[i].position;
            (*look.lights)[i].light.direction = scene.lights[i].direction;
        }
    if (look.keys.empty()) return;
    const Camera& camera = scene.cameras[0];
    Eye eye = eye_before(look.keys, time_s);
    eye.position = camera.to_world[3].xyz(), eye.up = camera.to_world[1].xyz();
    eye.focal = scene.lights[count].position;
    eye.fov_deg = degrees(camera.vertical_fov_rad);
    if (!(eye.focal == eye.position)) look.eye = eye;
}

}  // namespace rakelight::viewer
