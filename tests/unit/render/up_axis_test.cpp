// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "math/linear.h"
#include "render/up_axis.h"

namespace rakelight {
namespace {

/// A pyramid with its square base at the lowest z and its tip at the highest; axes put in another order.
Scene pyramid(std::size_t x, std::size_t y, std::size_t z) {
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    const double corners[5][3] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 2}};
    std::vector<vec3> positions;
    for (const auto& c : corners) positions.push_back({float(c[x]), float(c[y]), float(c[z])});
    mesh.positions = positions;
    mesh.indices = std::vector<std::uint32_t>{0, 2, 1, 0, 3, 2, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
    scene.nodes.push_back({.name = "pyramid", .meshes = {0}});
    return scene;
}

TEST(UpAxis, WhatStandsOnItsLowestZLooksZUp) {
    EXPECT_NE(why_z_is_up(pyramid(0, 1, 2)).find("flat base"), std::string::npos);
    EXPECT_EQ(why_z_is_up(pyramid(0, 2, 1)), "") << "it stands on its lowest y";
    EXPECT_EQ(why_z_is_up(pyramid(2, 1, 0)), "");
}

TEST(UpAxis, BoxesSayNothing) {
    Scene box;
    Mesh& mesh = box.meshes.emplace_back();
    std::vector<vec3> positions;
    for (int i = 0; i < 8; ++i) positions.push_back({float(i & 1), float(i >> 1 & 1), float(i >> 2 & 1)});
    mesh.positions = positions;
    mesh.indices = std::vector<std::uint32_t>{0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                              2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    box.nodes.push_back({.name = "box", .meshes = {0}});
    EXPECT_EQ(why_z_is_up(box), "");
    EXPECT_EQ(why_z_is_up(Scene{}), "");
}

TEST(UpAxis, SurveysAreFarFromZeroInXAndY) {
    Scene scene = pyramid(0, 2, 1);
    scene.meshes[0].origin = {431000, 5432000, 120};
    EXPECT_EQ(why_z_is_up(scene), "") << "z is far away too";
    scene.meshes[0].origin = {431000, 5432000, 3};
    EXPECT_NE(why_z_is_up(scene).find("survey"), std::string::npos);
}

TEST(UpAxis, FormatsWithoutOne) {
    for (const char* name : {"a.stl", "b.PLY", "c.obj", "d.off", "e.xyz"}) EXPECT_TRUE(has_no_up_axis(name)) << name;
    for (const char* name : {"a.glb", "b.fbx", "c.dae", "d.scene.toml", "builtin:teapot", "stl"})
        EXPECT_FALSE(has_no_up_axis(name)) << name;
}

}  // namespace
}  // namespace rakelight
