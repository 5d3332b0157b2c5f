// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <rakelight/render/shot.h>

#include "math/linear.h"
#include "render/camera/up_axis.h"

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

TEST(UpAxis, WhatStandsOnItsLowestYLooksYUp) {
    Scene scene = pyramid(0, 1, 2);
    EXPECT_EQ(why_y_is_up(scene), "");
    scene.nodes[0].local.matrix = dmat4{{{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}}};  // Z goes to Y
    EXPECT_NE(why_y_is_up(scene).find("lowest y"), std::string::npos);
    EXPECT_EQ(why_z_is_up(scene), "");
    EXPECT_EQ(why_y_is_up(Scene{}), "");
}

/// STL files have Z up, in any look, unless an axis is given; coordinates stay.
TEST(UpAxis, OfStlFilesIsZ) {
    const auto up_of = [](const std::string& name, PictureRequest request = {}) {
        Context context;
        request.input = name;
        apply_look(pyramid(0, 1, 2), request, context);
        return request.view.world_up;
    };
    const dvec3 z{0, 0, 1};
    EXPECT_EQ(up_of("a.stl"), z);
    EXPECT_EQ(up_of("a.STL", {.look = Look::standard}), z);
    for (const char* name : {"a.obj", "a.ply", "a.glb", "stl", "a.scene.toml"}) EXPECT_FALSE(up_of(name)) << name;
    EXPECT_FALSE(up_of("a.stl", {.given_keys = {"up"}}));
    EXPECT_EQ(up_of("a.stl", {.view = {.world_up = dvec3{0, 1, 0}}}), (dvec3{0, 1, 0}));
    EXPECT_EQ(up_of("a.stl", {.load = {.joined = {"b.stl"}}}), z);
    EXPECT_FALSE(up_of("a.stl", {.load = {.joined = {"b.glb"}}}));
}

TEST(UpAxis, AdviceIsSeenWithoutAskingForIt) {
    const auto advice = [](const std::string& name, const Scene& scene) {
        Context context;
        PictureRequest request{.input = name, .look = Look::standard};
        apply_look(scene, request, context);
        for (const ReportEntry& entry : context.report().entries())
            if (entry.message.find("turns it upright") != std::string::npos && entry.remark != Remark::note)
                return entry.message;
        return std::string();
    };
    const Scene z_up = pyramid(0, 1, 2);
    Scene y_up = z_up;
    y_up.nodes[0].local.matrix = dmat4{{{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}}};
    EXPECT_NE(advice("a.obj", z_up).find("'up' +Z"), std::string::npos);
    EXPECT_EQ(advice("a.stl", z_up), "");
    EXPECT_NE(advice("a.stl", y_up).find("'up' +Y"), std::string::npos);
    EXPECT_EQ(advice("a.obj", y_up), "");
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
