// SPDX-License-Identifier: Apache-2.0
// Worlds written as text: what is read again is the same world.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include <rakelight/io/world.h>

#include "math/linear.h"
#include "support/shared.h"
#include "support/temporary_folder.h"
#include "support/thrown_error.h"

namespace rakelight {
namespace {

using namespace test;

void expect_same(const WorldPlacement& a, const WorldPlacement& b) {
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.rotation_deg, b.rotation_deg);
    EXPECT_EQ(a.scale, b.scale);
}

template <class Part>
void expect_same_part(const Part& a, const Part& b) {
    EXPECT_EQ(a.name, b.name);
    expect_same(a.placement, b.placement);
    EXPECT_EQ(a.material, b.material);
    EXPECT_EQ(a.normals, b.normals);
    EXPECT_EQ(a.crease_angle_rad, b.crease_angle_rad);
    EXPECT_EQ(a.subdivision, b.subdivision);
    EXPECT_EQ(a.shading, b.shading);
}

void expect_same(const WorldModel& a, const WorldModel& b) {
    expect_same_part(a, b);
    EXPECT_EQ(a.file, b.file);
    EXPECT_EQ(a.lights, b.lights);
    EXPECT_EQ(a.cameras, b.cameras);
}

void expect_same(const WorldPrimitive& a, const WorldPrimitive& b) {
    expect_same_part(a, b);
    EXPECT_EQ(a.type, b.type);
    EXPECT_EQ(std::tie(a.radius, a.tube_radius, a.height, a.width, a.depth, a.objects, a.tolerance),
              std::tie(b.radius, b.tube_radius, b.height, b.width, b.depth, b.objects, b.tolerance));
    EXPECT_EQ(a.divisions, b.divisions);
}

void expect_same(const WorldMaterial& a, const WorldMaterial& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.model, b.model);
    ASSERT_EQ(a.values.size(), b.values.size());
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        EXPECT_EQ(a.values[i].key, b.values[i].key);
        EXPECT_EQ(a.values[i].words, b.values[i].words) << a.values[i].key;
        EXPECT_EQ(a.values[i].numbers, b.values[i].numbers) << a.values[i].key;
    }
}

void expect_same(const Light& a, const Light& b) { EXPECT_EQ(a, b) << a.name; }

void expect_same(const Camera& a, const Camera& b) {
    for (std::size_t column = 0; column < 4; ++column)
        EXPECT_LE(length(a.to_world[column].xyz() - b.to_world[column].xyz()), 1e-14) << a.name;
    Camera turned = b;
    turned.to_world = a.to_world;
    EXPECT_EQ(a, turned) << a.name;
}

template <class List>
void expect_same_list(const List& a, const List& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) expect_same(a[i], b[i]);
}

void expect_same(const WorldFile& a, const WorldFile& b) {
    expect_same_list(a.models, b.models);
    expect_same_list(a.primitives, b.primitives);
    expect_same_list(a.materials, b.materials);
    expect_same_list(a.lights, b.lights);
    expect_same_list(a.cameras, b.cameras);
    EXPECT_EQ(a.fog, b.fog);
    ASSERT_EQ(a.environment.has_value(), b.environment.has_value());
    if (a.environment) {
        EXPECT_EQ(a.environment->file, b.environment->file);
        EXPECT_EQ(a.environment->environment, b.environment->environment);
    }
    ASSERT_EQ(a.render.size(), b.render.size());
    for (std::size_t i = 0; i < a.render.size(); ++i) {
        EXPECT_EQ(a.render[i].key, b.render[i].key);
        EXPECT_EQ(a.render[i].words, b.render[i].words) << a.render[i].key;
        EXPECT_EQ(a.render[i].is_array, b.render[i].is_array) << a.render[i].key;
    }
}

void expect_round_trip(const std::string& text) {
    const WorldFile world = parse_world(text);
    const std::string written = to_toml(world);
    SCOPED_TRACE(written);
    expect_same(world, parse_world(written));
    EXPECT_FALSE(written.empty());
}

TEST(WriteWorld, EveryKeyOfPartsComesBack) {
    expect_round_trip(R"(
[[model]]
file = "sub folder/a \"b\".glb"
name = "tab\t and ü"
position = [0.1, -2e-7, 3e12]
rotation_deg = [33.3, 0, -90]
scale = [1, -1, 0.3]
material = "m"
normals = "model"
crease_angle_deg = 33.3
shading = "flat"
subdivide = 3
subdivide_scheme = "loop"
subdivide_crease_deg = 30.1
subdivide_sharpness = 2.5
subdivide_boundary = "edge"
subdivide_uv = "linear"
lights = true
cameras = true
[[primitive]]
type = "torus"
radius = 0.7
tube_radius = 0.2
objects = 7
tolerance = 0.003
scale = 2
subdivide_edge = 0.01
subdivide_crease = "auto"
[[primitive]]
type = "plane"
size = [3, 4.5]
divisions = 12
[[primitive]]
type = "cone"
height = 0.4
[[primitive]]
type = "teapot"
divisions = 4
[[primitive]]
type = "teapot"
tolerance = 0.01
[[material]]
name = "m"
color = "#ff8001"
unlit = false
double_sided = true
roughness = 0.3
texture_scale = [2, 3]
normal_texture = "n.png"
alpha = "mask"
bump_steps = [4, 40]
)");
}

TEST(WriteWorld, LightsCamerasAndSurroundingsComeBack) {
    expect_round_trip(R"(
[[primitive]]
type = "sphere"
[[light]]
type = "ambient"
ambient = [0, 0, 0]
[[light]]
type = "directional"
direction = [1, 2, -3]
casts_shadow = false
[[light]]
type = "point"
name = "lamp"
position = [1, 2, 3]
diffuse = [1, 0.1, 0.3]
specular = [0, 0, 0]
ambient = [0.1, 0.1, 0.1]
attenuation = [0.1, 0.2, 0.3]
range = 7.7
[[light]]
type = "spot"
position = [1, 2, 3]
direction = [0, -1, 0.1]
cutoff_deg = 33.3
exponent = 12
[[light]]
type = "photometric-spot"
position = [1, 2, 3]
direction = [0, -1, 0.1]
color = [1, 0.5, 0.25]
intensity_cd = 123.4
inner_cone_deg = 12.3
outer_cone_deg = 45.6
[[light]]
type = "photometric-directional"
direction = [0, -1, 0]
intensity_lux = 3.3
[[camera]]
name = "front"
position = [1, 2, 3]
target = [0.1, 0.2, 0.3]
vertical_fov_deg = 33.3
near = 0.01
far = 33
[[camera]]
position = [-1, 2, 3]
horizontal_fov_deg = 44.4
[[camera]]
position = [0, 0, 3]
vertical_fov_deg = 20
horizontal_fov_deg = 44.4
[[camera]]
position = [0, 5, 0]
up = [0, 0, 1]
orthographic_height = 3.3
[fog]
kind = "linear"
color = [0.1, 0.2, 0.3]
start = 1.1
end = 22.2
[environment]
file = "sky.hdr"
intensity = 0.3
rotation_deg = 33.3
light = false
[render]
resolution = "640,480"
samples = 4
light = ["point:1,2,3", "ambient:0.1,0.1,0.1"]
shadows = true
hdri-ambient = false
camera-index = "01"
)");
}

TEST(WriteWorld, WorldsOfTheRepositoryComeBack) {
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source_dir() / "data")) {
        if (!is_world_file(entry.path().string())) continue;
        std::stringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        SCOPED_TRACE(entry.path().string());
        expect_round_trip(text.str());
        ++count;
    }
    EXPECT_GT(count, 10);
}

TEST(WriteWorld, WhatNoFileCanHoldIsRefusedAndNothingIsWritten) {
    const TemporaryFolder folder;
    const std::string path = folder.file("w.scene.toml");
    WorldFile world = parse_world("[[primitive]]\ntype = 'sphere'\n");
    const auto refused = [&] { return error_of([&] { save_world(world, path); }); };
    world.lights.push_back({.name = "lamp", .node = 3});
    EXPECT_EQ(refused().reason(), "the light 'lamp' cannot stand in a world file: it hangs on a node");
    world.lights.clear();
    world.cameras.push_back({.name = "c", .aspect = 2});
    EXPECT_EQ(refused().code(), ErrorCode::usage);
    world.cameras[0] = {.z_far = std::numeric_limits<double>::infinity()};
    EXPECT_EQ(refused().code(), ErrorCode::usage);
    world.cameras.clear();
    world.render = {{.key = "nonsense", .words = {"1"}}};
    EXPECT_EQ(refused().code(), ErrorCode::usage);
    world.render = {{.key = "material", .words = {"roughness=1"}}};
    EXPECT_EQ(refused().code(), ErrorCode::usage);
    world.render = {{.key = "samples", .words = {}}};
    EXPECT_EQ(refused().setting(), "samples");
    world.render.clear();
    world.materials = {{.name = "m", .values = {{.key = "color = 1\n[fog]\nkind", .words = {"red"}}}}};
    EXPECT_EQ(refused().code(), ErrorCode::usage);
    world.materials.clear();
    world.lights = {{.type = LightType(9)}};
    EXPECT_EQ(refused().code(), ErrorCode::usage);
    world.lights.clear();
    world.fog = Fog{.kind = FogKind(7)};
    EXPECT_EQ(refused().code(), ErrorCode::usage);
    world.fog.reset();
    world.primitives[0].shading = Shading(99);
    EXPECT_EQ(refused().code(), ErrorCode::usage);
    world.primitives[0].shading.reset();
    world.environment.emplace();
    world.environment->environment.image = std::make_shared<const EncodedImage>();
    EXPECT_EQ(refused().code(), ErrorCode::usage);
    world.environment.reset();
    world.primitives[0].material = "there is none";
    EXPECT_EQ(refused().code(), ErrorCode::bad_file);
    world.primitives.clear();
    EXPECT_EQ(refused().reason(), "the world is empty");
    EXPECT_FALSE(std::filesystem::exists(path));
    EXPECT_EQ(error_of([&] { save_world(world, folder.file("w.toml")); }).file(), folder.file("w.toml"));
}

TEST(WriteWorld, SeveralWordsAreAnArrayHoweverTheyCame) {
    WorldFile world = parse_world("[[primitive]]\ntype = 'sphere'\n");
    world.render = {{.key = "light", .words = {"point:0,2,3", "ambient:1,1,1"}},
                    {.key = "resolution", .words = {"64", "48"}}};
    const WorldFile again = parse_world(to_toml(world));
    EXPECT_EQ(again.render.at(0).words, world.render[0].words);
    EXPECT_EQ(again.render.at(1).words, world.render[1].words);
}

TEST(WriteWorld, ASavedWorldIsReadFromItsFile) {
    const TemporaryFolder folder;
    Context context;
    WorldFile world = parse_world("[[primitive]]\ntype = 'cone'\nname = 'hat'\n");
    world.primitives[0].placement.position = {1, 2, 3};
    save_world(world, folder.file("w.scene.toml"));
    expect_same(world, read_world(folder.file("w.scene.toml"), context));
}

}  // namespace
}  // namespace rakelight
