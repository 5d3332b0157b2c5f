// SPDX-License-Identifier: Apache-2.0
#include "world/write_tracks.h"

#include <algorithm>
#include <set>
#include <vector>

#include "io/world/motion_keys.h"
#include "io/world/world_lights_cameras.h"
#include "world/keys/key_fields.h"

namespace rakelight {
namespace {

using io::world::MovingKey;

/// A track and its key.
struct KeyedTrack {
    const WorldTrack* track;
    const MovingKey* key;
};

const MovingKey& key_of(const WorldFile& world, const WorldTrack& track) {
    const bool is_camera = track.path == AnimationPath::camera;
    const bool is_lux = !is_camera && world.lights[track.element].type == LightType::directional;
    for (const MovingKey& key : is_camera ? io::world::moving_camera_keys() : io::world::moving_light_keys()) {
        const std::string_view name = key.key;
        if (track.property == key.property && (track.property != "intensity" || name.ends_with("lux") == is_lux))
            return key;
    }
    throw Error(ErrorCode::usage, "no key of a world file moves '" + one_line(track.property, 40) + "'");
}

/// Lights may have another type than when their tracks were read.
bool is_had(const WorldFile& world, const WorldTrack& track, const MovingKey& key) {
    if (track.path == AnimationPath::camera) return true;
    return std::ranges::any_of(io::world::keys_of(world.lights[track.element]),
                               [&](std::string_view name) { return name == key.key; });
}

std::string number_of(float number, MovingKey::Unit unit) {
    if (unit == MovingKey::Unit::degrees) return keys::degrees_of_float(number);
    return unit == MovingKey::Unit::twice ? keys::text_of(2 * double(number)) : keys::text_of_float(number);
}

/// ", position = [0, 1, 5]"
std::string text_of_key(const KeyedTrack& of, std::size_t k) {
    const std::size_t width = of.track->values.size() / of.track->times.size();
    std::string numbers;
    for (std::size_t i = 0; i < width; ++i)
        numbers += (i > 0 ? ", " : "") + number_of(of.track->values[k * width + i], of.key->unit);
    return ", " + std::string(of.key->key) + " = " + (width > 1 ? "[" + numbers + "]" : numbers);
}

std::string text_at(const std::vector<KeyedTrack>& tracks, float time) {
    std::string text = "    { time = " + keys::text_of_float(time);
    for (const KeyedTrack& of : tracks) {
        const auto& times = of.track->times;
        const auto key = std::ranges::find(times, time);
        if (key != times.end()) text += text_of_key(of, std::size_t(key - times.begin()));
    }
    return text + " },\n";
}

}  // namespace

std::string text_of_tracks(const WorldFile& world, AnimationPath path, std::size_t element) {
    std::vector<KeyedTrack> tracks;
    std::set<float> times;
    for (const WorldTrack& track : world.tracks) {
        if (track.path != path || track.element != element || track.times.empty()) continue;
        const MovingKey& key = key_of(world, track);
        if (!is_had(world, track, key)) continue;
        tracks.push_back({&track, &key});
        times.insert(track.times.begin(), track.times.end());
    }
    if (tracks.empty()) return {};
    std::string text = "keys = [\n";
    for (const float time : times) text += text_at(tracks, time);
    text += "]\n";
    const WorldTrack::Between between = tracks[0].track->between;
    if (between == WorldTrack::Between::step) text += "interpolation = \"step\"\n";
    if (between == WorldTrack::Between::smooth) text += "interpolation = \"smooth\"\n";
    return text;
}

}  // namespace rakelight
