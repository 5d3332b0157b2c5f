// SPDX-License-Identifier: Apache-2.0
#include <rakelight/scene/validate.h>

#include <gtest/gtest.h>

#include <limits>

#include "support/thrown_error.h"
#include "world/coloring.h"

namespace rakelight {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// Four points; the second mesh has no arrays.
Scene measured() {
    Scene scene;
    for (int m = 0; m < 2; ++m) {
        Mesh& mesh = scene.meshes.emplace_back();
        mesh.topology = Topology::points;
        mesh.positions = std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        mesh.indices = std::vector<std::uint32_t>{0, 1, 2, 3};
    }
    scene.meshes[0].colors = std::vector<vec4>(4, {1, 0, 0, 1});
    scene.meshes[0].arrays = {{"heat", 1, std::vector<float>{-2, 0, 2, nan}},
                              {"flow", 2, std::vector<float>{3, 4, 0, 1, 0, 0, 6, 8}}};
    scene.nodes.push_back({.name = "cloud", .meshes = {0, 1}});
    return scene;
}

Scene colored(const Coloring& coloring, Context& context) {
    Scene out = color_by_array(measured(), coloring, context);
    validate(out);
    return out;
}

vec3 color(const Scene& scene, std::size_t vertex) { return scene.meshes[0].colors[vertex].xyz(); }

TEST(ColorByArray, TheFirstArrayFromItsLeastToItsGreatest) {
    Context context({.threads = 1});
    const Scene scene = colored({.is_on = true}, context);
    EXPECT_EQ(color(scene, 0), color_of(ColorMap::viridis, 0));
    EXPECT_EQ(color(scene, 1), color_of(ColorMap::viridis, 0.5));
    EXPECT_EQ(color(scene, 2), color_of(ColorMap::viridis, 1));
    EXPECT_EQ(color(scene, 3), color_of(ColorMap::viridis, double(nan))) << "no number: gray";
    EXPECT_EQ(scene.materials.at(scene.meshes[0].material).model, MaterialModel::unlit);
    EXPECT_TRUE(scene.meshes[1].colors.empty());
    EXPECT_NE(scene.meshes[1].material, scene.meshes[0].material);
}

TEST(ColorByArray, ComponentsLengthsRangesAndMaps) {
    Context context({.threads = 1});
    const Scene length = colored({.is_on = true, .array = "flow", .map = ColorMap::gray}, context);
    EXPECT_EQ(color(length, 0), color_of(ColorMap::gray, 0.5)) << "5 of 0..10";
    const Scene second = colored({.is_on = true, .array = "flow", .component = 1, .map = ColorMap::turbo}, context);
    EXPECT_EQ(color(second, 0), color_of(ColorMap::turbo, 0.5)) << "4 of 0..8";
    const Scene narrow = colored({.is_on = true, .array = "heat", .range = dvec2{0, 1}}, context);
    EXPECT_EQ(color(narrow, 0), color_of(ColorMap::viridis, 0));
    EXPECT_EQ(color(narrow, 2), color_of(ColorMap::viridis, 1));
    EXPECT_EQ(completed(measured(), {.is_on = true}).range, (dvec2{-2, 2}));
}

TEST(ColorByArray, WhatIsNotThereIsSaidWithWhatThereIs) {
    const auto fault = [](Scene scene, const Coloring& coloring) {
        return test::error_of([&] { completed(scene, coloring); });
    };
    const Error unknown = fault(measured(), {.is_on = true, .array = "heart"});
    EXPECT_EQ(unknown.code(), ErrorCode::usage);
    EXPECT_EQ(unknown.setting(), "scalars");
    EXPECT_NE(std::string(unknown.what()).find("heat, flow"), std::string::npos) << unknown.what();
    EXPECT_EQ(fault(measured(), {.is_on = true, .array = "flow", .component = 2}).setting(), "coloring-component");
    EXPECT_NE(std::string(fault(Scene{}, {.is_on = true}).what()).find("no numbers"), std::string::npos);
}

TEST(ColorByArray, NamesOfGltfAreFoundWithoutTheirFirstCharacter) {
    Scene scene = measured();
    scene.meshes[0].arrays[0].name = "_HEAT";
    EXPECT_EQ(completed(scene, {.is_on = true, .array = "HEAT"}).array, "_HEAT");
}

TEST(ColorByArray, ArraysOfAnotherSizeAreNoValidScene) {
    Scene scene = measured();
    scene.meshes[0].arrays[0].values = std::vector<float>{1, 2};
    EXPECT_THROW(validate(scene), Error);
}

}  // namespace
}  // namespace rakelight
