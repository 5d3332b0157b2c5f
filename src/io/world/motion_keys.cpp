// SPDX-License-Identifier: Apache-2.0
#include "io/world/motion_keys.h"

#include <algorithm>

namespace rakelight::io::world {
namespace {

using Unit = MovingKey::Unit;

// In the order in which they are set: a camera turns to its target from its position, and then upright.
constexpr MovingKey of_cameras[] = {
    {"position", "position"},
    {"target", "target"},
    {"up", "up"},
    {"vertical_fov_deg", "vertical_fov", Unit::degrees},
    {"orthographic_height", "half_height", Unit::twice},
};
constexpr MovingKey of_lights[] = {
    {"position", "position"}, {"direction", "direction"},    {"ambient", "ambient"},
    {"diffuse", "diffuse"},   {"specular", "specular"},      {"color", "color"},
    {"range", "range"},       {"intensity_cd", "intensity"}, {"intensity_lux", "intensity"},
};

constexpr Word<WorldTrack::Between> between_words[] = {{"linear", WorldTrack::Between::linear},
                                                       {"step", WorldTrack::Between::step},
                                                       {"smooth", WorldTrack::Between::smooth}};

float in_scene(double number, Unit unit) {
    return float(unit == Unit::degrees ? radians(number) : unit == Unit::twice ? number / 2 : number);
}

float time_of(const SectionValues& key) { return float(key.number("time", 0)); }

void check_keys(const SectionValues& v) {
    if (v.tables().empty() && v.has("interpolation"))
        fail(v.place_of("interpolation"), "'interpolation' says how keys are joined, but there are no 'keys'");
    const SectionValues* before = nullptr;
    for (const SectionValues& key : v.tables()) {
        if (key.all().size() < 2) fail(key.place(), "a key with nothing but its 'time'");
        if (before && !(time_of(key) > time_of(*before)))
            fail(key.place_of("time"), "'time' must be later than that of the key before");
        before = &key;
    }
}

/// The tracks of one camera or light.
class TrackReader {
public:
    TrackReader(const SectionValues& values, AnimationPath path, std::size_t element) : values_(values) {
        model_.path = path, model_.element = std::uint32_t(element);
        model_.between = value_of(between_words, values.text("interpolation", "linear"));
    }

    bool moves(std::string_view key) const {
        return std::ranges::any_of(values_.tables(), [&](const SectionValues& t) { return t.has(key); });
    }

    void read(const MovingKey& moving) {
        WorldTrack track = track_of(moving.property);
        for (const SectionValues& key : values_.tables()) {
            const WorldValue* const value = key.find(moving.key);
            if (!value) continue;
            track.times.push_back(time_of(key));
            for (const double number : value->numbers) track.values.push_back(in_scene(number, moving.unit));
        }
        if (!track.times.empty()) tracks.push_back(std::move(track));
    }

    /// What stays as it is while something else moves.
    void hold(const char* property, dvec3 value) {
        WorldTrack track = track_of(property);
        track.times = {time_of(values_.tables()[0])};
        track.values = {float(value.x), float(value.y), float(value.z)};
        tracks.push_back(std::move(track));
    }

    void copy(std::string_view property, const char* as) {
        const auto from = std::ranges::find(tracks, property, &WorldTrack::property);
        WorldTrack track = *from;
        track.property = as;
        tracks.push_back(std::move(track));
    }

    std::vector<WorldTrack> tracks{};

private:
    WorldTrack track_of(const char* property) const {
        WorldTrack track = model_;
        track.property = property;
        return track;
    }

    const SectionValues& values_;
    WorldTrack model_{};
};

void append(std::vector<WorldTrack> tracks, WorldFile& world) {
    std::ranges::move(tracks, std::back_inserter(world.tracks));
}

}  // namespace

std::span<const MovingKey> moving_camera_keys() { return of_cameras; }
std::span<const MovingKey> moving_light_keys() { return of_lights; }

void add_camera_tracks(const SectionValues& v, WorldFile& world) {
    check_keys(v);
    TrackReader reader(v, AnimationPath::camera, world.cameras.size() - 1);
    const bool turns = reader.moves("position") || reader.moves("target") || reader.moves("up");
    for (const MovingKey& key : of_cameras) {
        reader.read(key);
        // A camera that moves keeps looking at its target and stays upright.
        if (!turns || reader.moves(key.key)) continue;
        if (std::string_view(key.key) == "target") reader.hold("target", v.vector("target", {0, 0, 0}));
        if (std::string_view(key.key) == "up") reader.hold("up", v.vector("up", {0, 1, 0}));
    }
    append(std::move(reader.tracks), world);
}

void add_light_tracks(const SectionValues& v, WorldFile& world) {
    check_keys(v);
    TrackReader reader(v, AnimationPath::light, world.lights.size() - 1);
    for (const MovingKey& key : of_lights) reader.read(key);
    if (reader.moves("diffuse") && !v.has("specular")) reader.copy("diffuse", "specular");  // its default
    append(std::move(reader.tracks), world);
}

}  // namespace rakelight::io::world
