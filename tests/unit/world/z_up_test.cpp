// SPDX-License-Identifier: Apache-2.0
// The axis that is up in files, and scenes with Z up that are turned.
#include <rakelight/base/report.h>

#include <gtest/gtest.h>

#include "math/linear.h"
#include "scene/placement.h"
#include "world/z_up.h"

namespace rakelight {
namespace {

TEST(ZUp, FormatsByTheEnding) {
    for (const char* name : {"a.stl", "b/a.STL"}) EXPECT_EQ(up_axis(name), UpAxis::z) << name;
    for (const char* name : {"a.ply", "a.off", "a.xyz", "a.pts"}) EXPECT_EQ(up_axis(name), UpAxis::open) << name;
    for (const char* name : {"a.obj", "a.glb", "a.fbx", "a.scene.toml", "stl", "", "builtin:teapot"})
        EXPECT_EQ(up_axis(name), UpAxis::y) << name;
}

TEST(ZUp, OfSeveralFilesIfItIsUpInAll) {
    EXPECT_TRUE(is_z_up("a.stl", std::vector<std::string>{"b.stl", "c.STL"}));
    EXPECT_FALSE(is_z_up("a.stl", std::vector<std::string>{"b.stl", "c.ply"}));
    EXPECT_FALSE(is_z_up("a.ply", std::vector<std::string>{"b.stl"}));
}

TEST(ZUp, AFileWithZUpLiesAmongOthers) {
    EXPECT_EQ(lying_file("a.stl", {}), std::nullopt);
    EXPECT_EQ(lying_file("a.glb", std::vector<std::string>{"b.ply"}), std::nullopt);
    EXPECT_EQ(lying_file("a.stl", std::vector<std::string>{"b.stl"}), std::nullopt);
    EXPECT_EQ(lying_file("a.stl", std::vector<std::string>{"b.stl", "c.ply"}), "a.stl");
    EXPECT_EQ(lying_file("a.glb", std::vector<std::string>{"b.ply", "c.stl"}), "c.stl");
}

/// (x, y, z) goes to (x, z, -y), exactly, below any root and through any parent.
TEST(ZUp, ATurnedSceneHasYUp) {
    Scene scene;
    scene.nodes.push_back({.name = "root"});
    scene.nodes.back().local.translation = {0.1, 0.2, 0.3};
    scene.nodes.push_back({.name = "child", .parent = 0});
    scene.nodes.back().local.scale = {2, 3, 4};
    scene.nodes.push_back({.name = "other root"});
    scene.lights.push_back({.position = {1, 2, 3}, .direction = {0, 0, -1}});
    scene.lights.push_back({.node = 1, .position = {1, 2, 3}});
    Camera& camera = scene.cameras.emplace_back();
    camera.to_world = look_at({5, 6, 7}, {0, 0, 0}, {0, 0, 1});
    const auto turned = [](dvec3 v) { return dvec3{v.x, v.z, -v.y}; };
    const std::vector<dmat4> before = world_matrices(scene);
    const Scene after = with_y_up(scene);
    const std::vector<dmat4> world = world_matrices(after);
    const dvec3 p{0.7, -0.11, 0.13};
    for (std::size_t n = 0; n < world.size(); ++n)
        EXPECT_EQ(transform_point(world[n], p), turned(transform_point(before[n], p))) << n;
    EXPECT_EQ(after.lights[0].position, (dvec3{1, 3, -2}));
    EXPECT_EQ(after.lights[0].direction, (dvec3{0, -1, 0}));
    EXPECT_EQ(after.lights[1].position, (dvec3{1, 2, 3})) << "its node turns it";
    EXPECT_EQ(transform_point(after.cameras[0].to_world, p), turned(transform_point(scene.cameras[0].to_world, p)));
}

/// Only an STL file turns, and only beside a format with Y up.
TEST(ZUp, TwoScenesShareOneAxis) {
    struct Case {
        const char *a, *b;
        std::optional<UpAxis> up;
        bool turns_a, turns_b;
    };
    constexpr Case cases[] = {{"a.stl", "b.glb", UpAxis::y, true, false},  {"a.glb", "b.stl", UpAxis::y, false, true},
                              {"a.stl", "", UpAxis::y, true, false},       {"a.stl", "b.ply", UpAxis::z, false, false},
                              {"a.xyz", "b.stl", UpAxis::z, false, false}, {"a.stl", "b.stl", {}, false, false},
                              {"a.ply", "b.obj", {}, false, false}};
    for (const Case& c : cases) {
        Scene a, b;
        a.source = c.a, b.source = c.b;
        for (Scene* scene : {&a, &b}) scene->nodes.emplace_back();
        Report report;
        EXPECT_EQ(share_up_axis(a, b, report), c.up) << c.a << c.b;
        EXPECT_EQ(report.entries().size(), c.turns_a || c.turns_b ? 1u : 0u) << c.a << c.b;
        const auto is_turned = [](const Scene& scene) {
            return transform_direction(world_matrices(scene)[0], dvec3{0, 0, 1}) == dvec3{0, 1, 0};
        };
        EXPECT_EQ(is_turned(a), c.turns_a) << c.a << c.b;
        EXPECT_EQ(is_turned(b), c.turns_b) << c.a << c.b;
    }
}

}  // namespace
}  // namespace rakelight
