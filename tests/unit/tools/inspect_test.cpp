// SPDX-License-Identifier: Apache-2.0
#include <rakelight/render/render.h>
#include <rakelight/tools/inspect.h>
#include <rakelight/tools/rows.h>

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>

#include "support/shared.h"
#include "tools/material_names.h"
#include "tools/text_table.h"
#include "unit/render/test_scene.h"

namespace rakelight {
namespace {

using test::two_squares;
using Has = ObjectSummary::Has;

TEST(Inspect, CountsObjectsMeshesAndAttributes) {
    Scene scene = two_squares();
    scene.materials.resize(2);
    scene.materials[0].name = "skin";
    scene.meshes[0].material = 0;
    scene.meshes[1].material = 1;
    scene.meshes[1].normals = {};
    scene.nodes[0].meshes = {0, 1};
    Context context;
    const Inspection i = inspect(scene, {}, context);
    ASSERT_EQ(i.objects.size(), 2u);
    EXPECT_EQ(i.objects[0].meshes, 2u);
    EXPECT_EQ(i.objects[0].triangles, 4u);
    EXPECT_EQ(i.objects[0].normals, Has::some);
    EXPECT_EQ(i.objects[0].tangents, Has::no);
    EXPECT_EQ(i.objects[0].materials, (std::vector<std::string>{"skin", "material 1"}));
    EXPECT_EQ(i.objects[1].normals, Has::no);
    EXPECT_EQ(i.triangles, 6u);
    EXPECT_EQ(i.low, (dvec3{-1, 0, 0}));
    EXPECT_EQ(i.high, (dvec3{1, 1, 0}));
    EXPECT_EQ(i.shared_positions, 4u);
    EXPECT_TRUE(i.scene.meshes.empty());
}

TEST(Inspect, AutomaticCreasesAreSummarized) {
    Inspection i;
    EXPECT_EQ(to_text(i).find("hard edges"), std::string::npos);
    i.creases.emplace();
    EXPECT_NE(to_text(i).find("  hard edges: none; soft: none\n"), std::string::npos) << to_text(i);
    i.creases->hard = 20, i.creases->hard_least_deg = 34.2, i.creases->hard_most_deg = 90;
    i.creases->soft = 7, i.creases->soft_most_deg = 30;
    i.creases->rings[6] = 2, i.creases->rings[8] = 1, i.creases->smooth_surfaces = 1;
    EXPECT_NE(
        to_text(i).find("  hard edges: 34 to 90 degrees; soft: up to 30 degrees; by convention: 2 prisms of 6 sides "
                        "as flat, 1 column of 8 sides as round, 1 surface of single triangles as smooth\n"),
        std::string::npos)
        << to_text(i);
    Context context;
    InspectOptions options;
    EXPECT_FALSE(inspect(two_squares(), options, context).creases);
    options.prepare.creases = Creasing::automatic;
    EXPECT_FALSE(inspect(two_squares(), options, context).creases) << "the file's normals count";
    options.prepare.normals = NormalSource::model;
    EXPECT_TRUE(inspect(two_squares(), options, context).creases);
}

TEST(Inspect, WhatDecidesNormalsIsALine) {
    Context context;
    InspectOptions options;
    EXPECT_FALSE(inspect(two_squares(), options, context).choices) << "the file's normals count";
    options.prepare.normals = NormalSource::model;
    Inspection i = inspect(two_squares(), options, context);
    ASSERT_TRUE(i.choices);
    EXPECT_GT(i.choices->smooth, 0u);
    i.choices = NormalChoices{.smooth = 1, .plane = 20, .fit = 978, .noise = 1};
    EXPECT_NE(to_text(i).find("  normals: 98% fitted, 2% of a plane, 0.1% nearly flat, 0.1% averaged over noise\n"),
              std::string::npos)
        << to_text(i);
    options.prepare.weight = CornerWeight::angle;
    EXPECT_FALSE(inspect(two_squares(), options, context).choices);
}

TEST(Inspect, MaterialsThatNoObjectHasAreUnused) {
    Scene scene = two_squares();
    scene.materials.resize(3);
    scene.materials[0].name = "old", scene.materials[1].name = "paint", scene.materials[2].name = "lost";
    scene.meshes[0].material = scene.meshes[1].material = 1;
    scene.meshes.push_back(scene.meshes[0]);  // that no node draws
    scene.meshes.back().material = 2;
    Context context;
    const Inspection i = inspect(scene, {}, context);
    EXPECT_EQ(i.material_objects, (std::vector<std::uint32_t>{0, 2, 0}));
    const std::string text = to_text(i);
    EXPECT_NE(text.find("3 materials (2 unused)"), std::string::npos) << text;
    EXPECT_NE(text.find("0  old    unused"), std::string::npos) << text;
    EXPECT_NE(text.find("1  paint  2"), std::string::npos) << text;
    const InspectionRow row{.file = "a", .inspection = i};
    const auto json = nlohmann::json::parse(to_json({&row, 1}));
    EXPECT_EQ(json["rows"][0]["materials"][1]["objects"], 2);
}

TEST(Inspect, ObjectsOfAWorldAreNamedAfterThePartThatTheyBelongTo) {
    Scene scene = two_squares();
    Node part;
    part.name = "shelf";
    for (Node& node : scene.nodes) node.parent = 0;
    scene.nodes.insert(scene.nodes.begin(), part);
    scene.nodes[1].name = "board", scene.nodes[2].name = "shelf 2";
    Context context;
    EXPECT_EQ(inspect(scene, {}, context).objects[0].name, "board");
    scene.source = "room.scene.toml";
    const Inspection i = inspect(scene, {}, context);
    EXPECT_EQ(i.objects[0].name, "shelf/board");
    EXPECT_EQ(i.objects[1].name, "shelf 2") << "of a primitive that was cut in pieces";
    scene.nodes[1].name = "shelf", scene.nodes[2].name = "shelfboard";
    const Inspection other = inspect(scene, {}, context);
    EXPECT_EQ(other.objects[0].name, "shelf");
    EXPECT_EQ(other.objects[1].name, "shelf/shelfboard") << "begins alike, but is a name of its own";
    scene.nodes[1].name.clear();
    EXPECT_EQ(inspect(scene, {}, context).objects[0].name, "shelf/node 1");
}

TEST(Inspect, ManyMaterialsOfOneObjectAreNamedOnceEach) {
    constexpr std::size_t count = 20000;
    Scene scene = two_squares();
    scene.materials.resize(count);
    const Mesh mesh = scene.meshes[0];
    scene.meshes.clear();
    for (std::uint32_t m = 0; m < count; ++m) {
        scene.materials[m].name = "m" + std::to_string(m / 2);
        scene.meshes.push_back(mesh);
        scene.meshes.back().material = m;
    }
    scene.nodes[0].meshes.resize(count);
    std::iota(scene.nodes[0].meshes.begin(), scene.nodes[0].meshes.end(), 0u);
    scene.nodes[1].meshes = {0};
    Context context;
    const Inspection i = inspect(scene, {.borders = false, .surfaces = false}, context);
    ASSERT_EQ(i.objects[0].materials.size(), count / 2);
    EXPECT_EQ(i.objects[0].materials.front(), "m0");
    EXPECT_EQ(i.objects[0].materials.back(), "m" + std::to_string(count / 2 - 1));
}

TEST(Inspect, AnEmptySceneIsNoReasonToFail) {
    Context context;
    const Inspection i = inspect(Scene{.source = "nothing.obj"}, {}, context);
    EXPECT_TRUE(i.objects.empty());
    EXPECT_NE(to_text(i).find("0 objects"), std::string::npos);
}

TEST(Inspect, AModelCutIntoSlabsHasSeamsPerObjectAndNoneOverTheModel) {
    Context context;
    const Scene scene = load((test::source_dir() / "data/spot/spot_slab5.glb").string(), {}, context);
    const auto largest = [&](NormalSource normals) {
        const Inspection i = inspect(scene, {.prepare = {.normals = normals, .crease_angle_rad = pi}}, context);
        EXPECT_EQ(i.objects.size(), 5u);
        EXPECT_EQ(i.shared_positions, 300u);  // as counted when the model was cut
        EXPECT_FALSE(i.borders.empty());
        return i.borders.empty() ? -1 : i.borders.front().largest_deg;
    };
    EXPECT_GT(largest(NormalSource::object), 20);
    EXPECT_LT(largest(NormalSource::model), 0.01);
}

TEST(Inspect, CamerasAreSaidByBothAxesWhereTheySayThem) {
    Scene scene = two_squares();
    scene.cameras.resize(5);
    for (Camera& c : scene.cameras) c.vertical_fov_rad = radians(90);
    scene.cameras[1].horizontal_fov_rad = radians(60);
    scene.cameras[2].aspect = 1 / std::sqrt(3.0);
    scene.cameras[3].projection = scene.cameras[4].projection = Projection::orthographic;
    scene.cameras[3].half_height = 2;
    scene.cameras[4].half_width = 3;
    Context context;
    std::vector<InspectionRow> rows(1);
    rows[0].inspection = inspect(scene, {}, context);
    const std::string text = to_text(*rows[0].inspection);
    EXPECT_NE(text.find("perspective, 90.0 degrees\n"), std::string::npos) << text;
    EXPECT_NE(text.find("perspective, 90.0 degrees high, 60.0 wide\n"), std::string::npos) << text;
    EXPECT_NE(text.find("orthographic, height 4\n"), std::string::npos) << text;
    EXPECT_NE(text.find("orthographic, height 2, width 6\n"), std::string::npos) << text;
    const auto cameras = nlohmann::json::parse(to_json(rows))["rows"][0]["cameras"];
    EXPECT_TRUE(cameras[0]["horizontal_fov_deg"].is_null());
    for (const std::size_t c : {1u, 2u}) EXPECT_NEAR(cameras[c]["horizontal_fov_deg"].get<double>(), 60, 1e-9);
    EXPECT_TRUE(cameras[3]["half_width"].is_null());
    EXPECT_EQ(cameras[4]["half_width"], 3);
}

TEST(Inspect, TextAndJsonSurviveHostileNames) {
    Scene scene = two_squares();
    scene.source = "two\n\033[31m.obj";
    scene.nodes[0].name = std::string(100000, 'x') + "\xFF";
    scene.cameras.resize(1);
    scene.cameras[0].z_far = std::numeric_limits<double>::infinity();
    scene.lights.resize(2);
    Context context;
    std::vector<InspectionRow> rows(2);
    rows[0].file = scene.source;
    rows[0].inspection = inspect(scene, {}, context);
    rows[1].file = "missing";
    rows[1].error = Error(ErrorCode::not_found, "no such file");
    const std::string text = to_text(*rows[0].inspection);
    EXPECT_EQ(text.find('\033'), std::string::npos);
    EXPECT_LT(text.size(), 4000u);
    const auto json = nlohmann::json::parse(to_json(rows));
    EXPECT_EQ(json["schema"], "rakelight.inspect/1");
    EXPECT_EQ(json["rows"][0]["objects"].size(), 2u);
    EXPECT_TRUE(json["rows"][0]["cameras"][0]["far"].is_null());
    EXPECT_EQ(json["rows"][0]["borders"][0]["positions"], 2);
    EXPECT_EQ(json["rows"][1]["error"]["code"], "not_found");
}

TEST(Inspect, NamesOfTexturesStayTheSame) {
    Material m;
    m.model = MaterialModel::metallic_roughness;
    m.base_color_texture = m.normal_texture = m.metallic_roughness.texture = m.metallic_roughness.specular_texture =
        m.metallic_roughness.specular_color_texture = {.texture = 0};
    std::vector<std::string> names;
    for (const auto& [name, use] : named_texture_uses(m)) names.emplace_back(name);
    EXPECT_EQ(names,
              (std::vector<std::string>{"base_color", "normal", "metallic_roughness", "specular", "specular_color"}));
}

TEST(TextTable, LinesUpColumnsAndCutsBlanksAtTheEnd) {
    TextTable table({"name", ">count", "what"});
    table.add({"a", "1", "x"});
    table.add({"\xC3\xA4\xC3\xB6", "1000", ""});
    EXPECT_EQ(table.text("  "), "  name  count  what\n  a         1  x\n  \xC3\xA4\xC3\xB6     1000\n");
}

}  // namespace
}  // namespace rakelight
