// SPDX-License-Identifier: Apache-2.0
// `keys` of cameras and lights in world files, as they are read.
#include <gtest/gtest.h>
#include <rakelight/io/world.h>

#include <nlohmann/json.hpp>

#include "math/linear.h"
#include "support/thrown_error.h"

namespace rakelight::test {
namespace {

WorldFile with_teapot(const std::string& text) { return parse_world("[[primitive]]\ntype = 'teapot'\n" + text); }

const WorldTrack& track_of(const WorldFile& world, std::string_view property) {
    const auto track = std::ranges::find(world.tracks, property, &WorldTrack::property);
    if (track == world.tracks.end()) throw std::runtime_error("there is no track of " + std::string(property));
    return *track;
}

using Numbers = std::vector<float>;

TEST(MotionKeys, ACameraStandsWhereItsFirstKeySaysUnlessItSaysItself) {
    const WorldFile w = with_teapot(R"(
[[camera]]
target = [0, 0.5, 0]
interpolation = "smooth"
keys = [
  { time = -1, position = [0, 1, 5], vertical_fov_deg = 90 },
  { time = 2, position = [5, 1, 0] },  # the angle stays
]
)");
    EXPECT_EQ(w.cameras.at(0).to_world[3].xyz(), (dvec3{0, 1, 5}));
    EXPECT_NEAR(w.cameras[0].vertical_fov_rad, pi / 2, 1e-12);
    ASSERT_EQ(w.tracks.size(), 4u);  // target and up hold while it goes
    const WorldTrack& position = track_of(w, "position");
    EXPECT_EQ(position.path, AnimationPath::camera);
    EXPECT_EQ(position.between, WorldTrack::Between::smooth);
    EXPECT_EQ(position.times, (Numbers{-1, 2}));
    EXPECT_EQ(position.values, (Numbers{0, 1, 5, 5, 1, 0}));
    EXPECT_EQ(track_of(w, "target").values, (Numbers{0, 0.5f, 0}));
    EXPECT_EQ(track_of(w, "up").values, (Numbers{0, 1, 0}));
    EXPECT_EQ(track_of(w, "vertical_fov").values, Numbers{float(radians(90))});
}

TEST(MotionKeys, LightsMoveByTheirOwnKeys) {
    const WorldFile w = with_teapot(R"(
[[light]]
type = "point"
position = [0, 3, 0]
keys = [{ time = 0, diffuse = "#ffffff" }, { time = 1, diffuse = [1, 0, 0] }]
[[light]]
type = "photometric-directional"
direction = [0, -1, 0]
interpolation = "step"
keys = [{ time = 0, intensity_lux = 2 }, { time = 1, intensity_lux = 4 }]
)");
    ASSERT_EQ(w.tracks.size(), 3u);
    EXPECT_EQ(track_of(w, "specular").values, (Numbers{1, 1, 1, 1, 0, 0})) << "as diffuse, unless said";
    const WorldTrack& intensity = track_of(w, "intensity");
    EXPECT_EQ(intensity.element, 1u);
    EXPECT_EQ(intensity.between, WorldTrack::Between::step);
    EXPECT_EQ(intensity.values, (Numbers{2, 4}));
    EXPECT_EQ(w.lights[0].diffuse, (vec3{1, 1, 1}));
    EXPECT_EQ(w.lights[1].intensity, 2);
}

TEST(MotionKeys, EveryFaultIsSaidWithItsLineAndColumn) {
    const auto fault = [](const std::string& section, const std::string& text) {
        const Error error = error_of([&] { with_teapot("[[" + section + "]]\n" + text); });
        EXPECT_EQ(error.code(), ErrorCode::bad_file);
        return error.place() + ": " + error.reason();
    };
    const std::string camera = "camera", light = "light";
    EXPECT_EQ(fault(camera, "keys = []"), "line 4, column 8: 'keys' is empty");
    EXPECT_EQ(fault(camera, "keys = 3"), "line 4, column 8: 'keys' must be a list of tables");
    EXPECT_EQ(fault(camera, "keys = [{ time = 0 }]\nposition = [0, 0, 1]"),
              "line 4, column 9: a key with nothing but its 'time'");
    EXPECT_EQ(fault(camera, "keys = [{ position = [0, 0, 1] }]"),
              "line 4, column 9: [[camera.keys]] lacks the key 'time'");
    EXPECT_EQ(fault(camera, "keys = [{ time = 0, position = [0, 0, 1] },\n { time = 0, position = [0, 0, 2] }]"),
              "line 5, column 11: 'time' must be later than that of the key before");
    EXPECT_EQ(fault(camera, "keys = [{ time = 0, place = [0, 0, 1] }]"),
              "line 4, column 21: unknown key 'place' in [[camera.keys]]");
    EXPECT_EQ(fault(camera, "keys = [{ time = nan, position = [0, 0, 1] }]"),
              "line 4, column 18: 'time' must be a finite number");
    EXPECT_EQ(fault(camera, "keys = [{ time = 0, target = [0, 0, 1] }]"),
              "line 3, column 1: [[camera]] lacks the key 'position'");
    EXPECT_EQ(fault(camera, "position = [0, 0, 1]\ninterpolation = 'step'"),
              "line 5, column 17: 'interpolation' says how keys are joined, but there are no 'keys'");
    EXPECT_EQ(
        fault(camera, "orthographic_height = 2\nkeys = [{ time = 0, position = [0, 0, 1], vertical_fov_deg = 9 }]"),
        "line 5, column 62: 'vertical_fov_deg' and 'orthographic_height' exclude each other");
    EXPECT_EQ(fault(light, "type = 'point'\nkeys = [{ time = 0, position = [0, 0, 1], color = 'red' }]"),
              "line 5, column 51: a light of type 'point' has no 'color'");
    EXPECT_EQ(fault(light, "type = 'spot'\nkeys = [{ time = 0, position = [0, 0, 1] }]"),
              "line 3, column 1: a light of type 'spot' lacks the key 'direction'");
    std::string many = "position = [0, 0, 1]\nkeys = [";
    for (int i = 0; i <= 10'000; ++i) many += "{ time = " + std::to_string(i) + ", up = [0, 1, 0] },";
    EXPECT_EQ(fault(camera, many + "]"), "line 5, column 8: more than 10000 of 'keys'");
}

TEST(MotionKeys, AreInTheSchema) {
    const nlohmann::json camera = nlohmann::json::parse(world_schema())["properties"]["camera"]["items"];
    EXPECT_FALSE(camera.contains("required")) << "keys may say the position";
    const nlohmann::json& key = camera["properties"]["keys"]["items"];
    EXPECT_EQ(key["required"], nlohmann::json{"time"});
    EXPECT_EQ(key["properties"]["position"]["minItems"], 3);
}

}  // namespace
}  // namespace rakelight::test
