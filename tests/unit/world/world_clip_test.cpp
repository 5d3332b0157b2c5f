// SPDX-License-Identifier: Apache-2.0
// What the keys of a world's cameras and lights make of its scene at a moment.
#include <gtest/gtest.h>

#include <cmath>

#include <rakelight/scene/motion.h>
#include <rakelight/world/load.h>
#include <rakelight/world/request.h>

#include "math/linear.h"
#include "support/temporary_folder.h"
#include "support/thrown_error.h"
#include "world/world_clip.h"

namespace rakelight::test {
namespace {

constexpr const char* sphere = "[[primitive]]\ntype = 'sphere'\ntolerance = 0.1\n";

Scene loaded(const std::string& text) {
    const TemporaryFolder folder;
    Context context({.threads = 1});
    return load(folder.write("a.scene.toml", text), {}, context);
}

Scene at(const Scene& scene, double time_s, MotionRequest motion = {}) {
    motion.time_s = time_s;
    return scene_at(scene, clips_of(scene, motion));
}

dvec3 eye(const Scene& scene, std::size_t camera = 0) { return scene.cameras[camera].to_world[3].xyz(); }

void expect_near(dvec3 a, dvec3 b, double tolerance = 1e-6) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

std::string camera_with(const std::string& interpolation, const std::string& keys) {
    return sphere + std::string("[[camera]]\ninterpolation = '") + interpolation + "'\nkeys = [" + keys + "]\n";
}

TEST(WorldClip, LinearAndStepKeys) {
    const std::string keys =
        "{ time = 1, position = [0, 0, 8] }, { time = 3, position = [4, 0, 8], vertical_fov_deg = 60 }";
    const Scene linear = loaded(camera_with("linear", keys)), step = loaded(camera_with("step", keys));
    ASSERT_EQ(linear.animations.size(), 1u);
    EXPECT_EQ(linear.animations[0].name, "world");
    EXPECT_EQ(eye(at(linear, 0)), (dvec3{0, 0, 8}));
    EXPECT_EQ(eye(at(linear, 2.5)), (dvec3{3, 0, 8}));
    EXPECT_EQ(eye(at(linear, 9)), (dvec3{4, 0, 8}));
    EXPECT_EQ(eye(at(step, 2.5)), (dvec3{0, 0, 8}));
    EXPECT_EQ(eye(at(step, 3)), (dvec3{4, 0, 8}));
    EXPECT_NEAR(at(linear, 0).cameras[0].vertical_fov_rad, radians(60), 1e-7) << "one key holds at all times";
}

TEST(WorldClip, SmoothKeysOfAParabolaLieOnIt) {
    std::string keys;
    for (const double t : {0.0, 1.0, 1.5, 4.0})
        keys += "{ time = " + std::to_string(t) + ", position = [" + std::to_string(t * t) + ", " +
                std::to_string(3 * t) + ", 9] },";
    const Scene scene = loaded(camera_with("smooth", keys));
    for (const double t : {0.25, 1.25, 2.0, 3.5}) expect_near(eye(at(scene, t)), {t * t, 3 * t, 9});
}

TEST(WorldClip, SmoothKeysTurnWithoutAKnee) {
    const Scene scene = loaded(camera_with(
        "smooth",
        "{ time = 0, position = [0, 0, 5] }, { time = 1, position = [1, 0, 5] }, { time = 3, position = [0, 2, 5] }"));
    const double h = 1e-3;
    const dvec3 before = (eye(at(scene, 1)) - eye(at(scene, 1 - h))) * (1 / h),
                behind = (eye(at(scene, 1 + h)) - eye(at(scene, 1))) * (1 / h);
    expect_near(before, behind, 0.01);
    expect_near(before, {0.5, 1.0 / 3, 0}, 0.01);  // (2 (1, 0) + 1 (-1/2, 1)) / 3
}

// Half way round: it looks at the target, and what is up stays so.
TEST(WorldClip, ACameraThatGoesAroundLooksAtItsTargetUpright) {
    const Scene scene = loaded(camera_with("linear", R"({ time = 0, position = [0, 4, 4] },
        { time = 1, position = [4, 4, 0] }, { time = 2, position = [0, 4, -4] }, { time = 3, position = [0, 4, 0] })"));
    const double r = std::sqrt(0.5);
    for (const double time : {0.0, 1.0, 2.0}) {
        const dmat4 m = at(scene, time).cameras[0].to_world;
        expect_near(m[2].xyz(), normalize_or(m[3].xyz(), dvec3{}));
        EXPECT_NEAR(m[1].y, r, 1e-6);
    }
    expect_near(at(scene, 3).cameras[0].to_world[1].xyz(), {0, 0, -1});  // straight down, as from the top
}

TEST(WorldClip, LightsMove) {
    const Scene scene = loaded(sphere + std::string(R"(
[[light]]
type = "photometric-spot"
keys = [{ time = 0, position = [0, 4, 0], direction = [0, -1, 0], intensity_cd = 100, color = [1, 0, 0] },
        { time = 2, position = [2, 4, 0], direction = [1, 0, 0], intensity_cd = 200, color = [0, 1, 0] }]
)"));
    const Light light = at(scene, 1).lights[0];
    EXPECT_EQ(light.position, (dvec3{1, 4, 0}));
    expect_near(light.direction, {std::sqrt(0.5), -std::sqrt(0.5), 0});
    EXPECT_EQ(light.intensity, 150);
    EXPECT_EQ(light.color, (vec3{0.5f, 0.5f, 0}));
}

/// A triangle that goes 1 m along x in a second, "go", and a light that grows from 0 to 2 cd, "shine".
constexpr const char* model = R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0, 1]}],
"nodes": [{"mesh": 0}, {"extensions": {"KHR_lights_punctual": {"light": 0}}}],
"extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}]}},
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"buffers": [{"byteLength": 76, "uri": "a.bin"}],
"bufferViews": [{"buffer": 0, "byteLength": 76}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
 {"bufferView": 0, "byteOffset": 36, "componentType": 5126, "count": 2, "type": "SCALAR"},
 {"bufferView": 0, "byteOffset": 44, "componentType": 5126, "count": 2, "type": "VEC3"},
 {"bufferView": 0, "byteOffset": 68, "componentType": 5126, "count": 2, "type": "SCALAR"}],
"animations": [
 {"name": "go", "samplers": [{"input": 1, "output": 2}], "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]},
 {"name": "shine", "samplers": [{"input": 1, "output": 3}], "channels": [{"sampler": 0, "target": {"path": "pointer",
  "extensions": {"KHR_animation_pointer": {"pointer": "/extensions/KHR_lights_punctual/lights/0/intensity"}}}}]}]})";

/// A world with the model, and a light and a camera of its own that moves.
Scene world_with_model() {
    const TemporaryFolder folder;
    const float numbers[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, /*times*/ 0, 1, /*places*/ 0, 0, 0, 1, 0, 0, /*candela*/ 0, 2};
    folder.write("a.bin", std::string(reinterpret_cast<const char*>(numbers), sizeof numbers));
    folder.write("a.gltf", model);
    Context context({.threads = 1});
    return load(folder.write("a.scene.toml", R"(
[[model]]
file = "a.gltf"
lights = true
[[light]]
type = "ambient"
ambient = [1, 1, 1]
[[camera]]
keys = [{ time = 0, position = [0, 0, 8] }, { time = 1, position = [4, 0, 8] }]
)"),
                {}, context);
}

TEST(WorldClip, IsShownWithEveryOtherClip) {
    const Scene scene = world_with_model();
    ASSERT_EQ(scene.animations.size(), 3u);
    const auto moved = [](const Scene& s) { return s.pose->local[1].translation.x; };  // node 0 is the model's root
    MotionRequest motion;
    Scene shown = at(scene, 0.5, motion);  // the first clip that is not the world's own
    EXPECT_EQ(moved(shown), 0.5);
    EXPECT_EQ(eye(shown), (dvec3{2, 0, 8}));
    EXPECT_EQ(shown.lights[1].intensity, 1);

    motion.name = "shine";
    shown = at(scene, 0.25, motion);
    EXPECT_EQ(moved(shown), 0);
    EXPECT_EQ(eye(shown), (dvec3{1, 0, 8}));
    EXPECT_EQ(shown.lights[1].intensity, 0.5f) << "its light stands behind the world's own";

    motion = {.index = -1};
    shown = at(scene, 0.5, motion);
    EXPECT_EQ(moved(shown), 0.5);
    EXPECT_EQ(eye(shown), (dvec3{2, 0, 8}));
    EXPECT_EQ(clips_of(scene, motion).size(), 3u) << "each once";

    motion = {.name = "world"};
    shown = at(scene, 0.5, motion);
    EXPECT_EQ(moved(shown), 0);
    EXPECT_EQ(eye(shown), (dvec3{2, 0, 8}));
    EXPECT_TRUE(clips_of(scene, {}).empty()) << "nobody asks for a moment";
}

TEST(WorldClip, KeysAreWrittenAndReadAgain) {
    const WorldFile world = parse_world(sphere + std::string(R"(
[[light]]
type = "spot"
direction = [0, -1, 0]
interpolation = "step"
keys = [{ time = 0.1, position = [0, 4, 0.1], diffuse = [0.3, 0, 1] }, { time = 0.3, diffuse = [1, 1, 1] }]
[[light]]
type = "photometric-directional"
keys = [{ time = 0, direction = [0, -1, 0], intensity_lux = 0.7 }, { time = 1, intensity_lux = 3 }]
[[camera]]
name = "path"
interpolation = "smooth"
keys = [{ time = -1.7, position = [0, 1, 5], vertical_fov_deg = 33.3 },
        { time = 0, vertical_fov_deg = 44.4 }, { time = 2, position = [5, 1, 0], target = [0, 1, 0.1] }]
[[camera]]
keys = [{ time = 0, position = [0, 0, 5], orthographic_height = 3.3 }, { time = 1, orthographic_height = 1.1 }]
)"));
    EXPECT_EQ(world.tracks.size(), 13u);
    const WorldFile again = parse_world(to_toml(world));
    ASSERT_EQ(again.tracks.size(), world.tracks.size());
    for (std::size_t i = 0; i < world.tracks.size(); ++i)
        EXPECT_EQ(again.tracks[i], world.tracks[i]) << world.tracks[i].property;
}

TEST(WorldClip, TracksOfWhatIsNotThereAreLeftOutAndBrokenOnesRefused) {
    WorldFile world =
        parse_world(camera_with("linear", "{ time = 0, position = [0, 0, 8] }, { time = 1, position = [1, 0, 8] }"));
    world.tracks[0].element = 3;
    EXPECT_EQ(world_clip(world).channels.size(), world.tracks.size() - 1);
    EXPECT_EQ(parse_world(to_toml(world)).cameras.size(), 1u);
    world.tracks[0].times = {1, 0};
    EXPECT_EQ(error_of([&] { to_toml(world); }).code(), ErrorCode::usage);
}

TEST(WorldClip, TracksThatALightOfAnotherTypeHasNoKeyForAreNotWritten) {
    WorldFile world = parse_world(sphere + std::string(R"(
[[light]]
type = "point"
keys = [{ time = 0, position = [0, 4, 0], diffuse = [1, 1, 1] }, { time = 1, position = [4, 4, 0] }]
)"));
    world.lights[0].units = LightUnits::photometric;
    const WorldFile again = parse_world(to_toml(world));
    ASSERT_EQ(again.tracks.size(), 1u);
    EXPECT_EQ(again.tracks[0].property, "position");
}

}  // namespace
}  // namespace rakelight::test
