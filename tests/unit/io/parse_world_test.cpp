// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/io/world.h>
#include <rakelight/io/world_words.h>
#include <rakelight/scene/words.h>
#include <cmath>
#include <limits>

#include "io/world/world_keys.h"
#include "math/linear.h"
#include "support/thrown_error.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr const char* teapot = "[[primitive]]\ntype = 'teapot'\n";

/// Parses text behind two lines with a teapot.
WorldFile with_teapot(const std::string& text) { return parse_world(teapot + text); }

}  // namespace

TEST(ParseWorld, TheExampleOfTheFormatIsRead) {
    const WorldFile w = parse_world(R"(
[[model]]
file = "teapot.obj"
position = [0, 0, 0]
rotation_deg = [0, 45, 0]
scale = 1.5
normals = "model"
crease_angle_deg = 60
[[primitive]]
type = "sphere"
radius = 2.0
[[light]]
type = "point"
position = [3, 4, 2]
ambient = [0, 0, 0]
diffuse = [1, 0.5, 1]
attenuation = [1, 0.1, 0.01]
[[light]]
type = "directional"
direction = [0, -2, 0]
[[light]]
type = "photometric-point"
position = [0, 5, 0]
intensity_cd = 400
[[camera]]
name = "front"
position = [0, 1, 5]
target = [0, 0.5, 0]
vertical_fov_deg = 40
near = 0.1
far = 100
[render]
engine = "soft"
resolution = [1280, 720]
)");
    ASSERT_EQ(w.models.size(), 1u);
    EXPECT_EQ(w.models[0].name, "teapot");
    EXPECT_EQ(w.models[0].placement.rotation_deg, (dvec3{0, 45, 0}));
    EXPECT_EQ(w.models[0].placement.scale, (dvec3{1.5, 1.5, 1.5}));
    EXPECT_EQ(w.models[0].normals, "model");
    EXPECT_NEAR(*w.models[0].crease_angle_rad, radians(60), 1e-12);
    EXPECT_EQ(w.primitives.at(0).radius, 2);
    ASSERT_EQ(w.lights.size(), 3u);
    EXPECT_EQ(w.lights[0].specular, (vec3{1, 0.5f, 1}));  // as diffuse
    EXPECT_EQ(w.lights[0].quadratic, 0.01f);
    EXPECT_TRUE(std::isinf(w.lights[0].range));
    EXPECT_EQ(w.lights[1].direction, (dvec3{0, -1, 0}));
    EXPECT_EQ(w.lights[2].units, LightUnits::photometric);
    EXPECT_EQ(w.lights[2].intensity, 400);
    ASSERT_EQ(w.cameras.size(), 1u);
    EXPECT_EQ(w.cameras[0].to_world[3].xyz(), (dvec3{0, 1, 5}));
    EXPECT_NEAR(w.cameras[0].to_world[2].y, 0.5 / std::sqrt(25.25), 1e-12);  // away from the target
    ASSERT_EQ(w.render.size(), 2u);
    EXPECT_EQ(w.render[1].key, "resolution");
    EXPECT_EQ(w.render[1].words, (std::vector<std::string>{"1280", "720"}));
    EXPECT_EQ(w.render[1].place, (WorldPlace{34, 1}));
}

TEST(ParseWorld, HexColorsAreAsSeenAndNumbersAreLight) {
    const WorldFile w =
        with_teapot("[[material]]\nname = 'a'\ncolor = '#80ff00'\n[[material]]\nname = 'b'\ncolor = [0.5, 2, 0]\n");
    EXPECT_NEAR(w.materials.at(0).values.at(0).numbers[0], 0.2158605, 1e-6);
    EXPECT_EQ(w.materials[0].values[0].numbers[1], 1);
    EXPECT_EQ(w.materials.at(1).values.at(0).numbers, (std::vector<double>{0.5, 2, 0}));
}

TEST(ParseWorld, ShadingIsOfThePartThatSaysItWhateverItsName) {
    const WorldFile w = parse_world(
        "[[primitive]]\ntype = 'teapot'\nshading = 'flat'\n[[primitive]]\ntype = 'teapot'\n[[model]]\nfile = "
        "'teapot.obj'\nshading = 'gouraud'\n[[material]]\nname = '*'\nmodel = 'teapot'\nshading = 'unlit'\n");
    EXPECT_EQ(w.primitives.at(0).shading, Shading::flat);
    EXPECT_EQ(w.primitives.at(1).shading, std::nullopt);
    EXPECT_EQ(w.models.at(0).shading, Shading::gouraud);
    EXPECT_EQ(w.materials.at(0).values.at(0).words, std::vector<std::string>{"unlit"});
    EXPECT_TRUE(w.render.empty());
}

TEST(ParseWorld, LettersBeyondAsciiStandInTextsAndCommentsAndNotInKeys) {
    for (const std::string letter :
         {"\xc2\xa1", "\xc3\xa9", "\xd1\x9a", "\xd2\x99", "\xd2\x9a", "\xe2\x80\xb0", "\xe6\x97\xa5"}) {
        const WorldFile w = with_teapot("[[camera]]  # " + letter + "\nposition = [1, 1, 1]\nname = \"\"\"a\\\n  " +
                                        letter + "\"\"\"\n");
        EXPECT_EQ(w.cameras.at(0).name, "a" + letter);
        for (const std::string& text :
             {letter + " = 1\n", "[" + letter + "]\n", "[" + letter + "x'\n", "a = 1" + letter + "\n"}) {
            const Error error = error_of([&] { with_teapot(text); });
            EXPECT_TRUE(error.place().starts_with("line 3, column ")) << text << error.place();
        }
    }
}

TEST(ParseWorld, AWordOfNoListIsAnErrorAndNotTheFirstOfTheList) {
    EXPECT_EQ(io::world::value_of(shading_words, "flat"), Shading::flat);
    EXPECT_THROW(io::world::value_of(shading_words, "flatt"), Error);
    EXPECT_THROW(io::world::value_of(shading_words, ""), Error);
}

TEST(ParseWorld, WorldFilesAreKnownByTheirEnding) {
    EXPECT_TRUE(is_world_file("a.scene.toml"));
    EXPECT_TRUE(is_world_file("b/A.Scene.TOML"));
    EXPECT_FALSE(is_world_file("a.toml"));
    EXPECT_FALSE(is_world_file(".scene.toml"));
    EXPECT_FALSE(is_world_file("scene.toml.glb"));
}

TEST(ParseWorld, EveryFaultIsSaidWithItsLineAndColumn) {
    const struct {
        const char *text, *place, *words;
    } faults[] = {
        {"[[model]]\nfile = 'a.obj'\npostion = [0, 0, 0]\n", "line 5, column 1", "unknown key 'postion'"},
        {"[[model]]\nposition = [0, 0, 0]\n", "line 3, column 1", "lacks the key 'file'"},
        {"[[model]]\nfile = 'a.obj'\nposition = [0, 0]\n", "line 5, column 12", "three numbers in brackets, not 2"},
        {"[[model]]\nfile = 'a.obj'\nposition = [0, 0, nan]\n", "line 5, column 19", "finite"},
        {"[[model]]\nfile = 'a.obj'\nscale = 0\n", "line 5, column 9", "must not be 0"},
        {"[[model]]\nfile = 'a.obj'\nscale = inf\n", "line 5, column 9", "finite"},
        {"[[model]]\nfile = 7\n", "line 4, column 8", "a text in quotes, not a number"},
        {"[[model]]\nfile = 'b.scene.toml'\n", "line 4, column 8", "cannot contain another"},
        {"[model]\nfile = 'a.obj'\n", "line 3, column 2", "list of tables"},
        {"[[model]]\nfile = 'a.obj'\nmaterial = 'gold'\n", "line 5, column 12", "no [[material]] named 'gold'"},
        {"[[ligth]]\ntype = 'point'\n", "line 3, column 3", "unknown section 'ligth'"},
        {"[[light]]\ntype = 'sun'\n", "line 4, column 8", "unknown word 'sun'"},
        {"[[light]]\ntype = 'point'\n", "line 3, column 1", "lacks the key 'position'"},
        {"[[light]]\ntype = 'point'\nposition = [0, 0, 0]\ncutoff_deg = 3\n", "line 6, column 14",
         "has no 'cutoff_deg'"},
        {"[[light]]\ntype = 'spot'\nposition = [0, 0, 0]\ndirection = [0, 0, 1]\ncutoff_deg = 0\n", "line 7, column 14",
         "0.001"},
        {"[[light]]\ntype = 'point'\nposition = [0, 0, 0]\nrange = 1e-50\n", "line 6, column 9", "1e-06"},
        {"[[light]]\ntype = 'directional'\ndirection = [0, 0, 0]\n", "line 5, column 13", "must not be zero"},
        {"[[light]]\ntype = 'point'\nposition = [0, 0, 0]\ndiffuse = [1, -1, 1]\n", "line 6, column 15", "at least 0"},
        {"[[camera]]\nposition = [1, 1, 1]\ntarget = [1, 1, 1]\n", "line 4, column 12", "must not be the same"},
        {"[[camera]]\nposition = [1, 1, 1]\nnear = 3\nfar = 2\n", "line 6, column 7", "'far' must be more"},
        {"[[camera]]\nposition = [1, 1, 1]\nvertical_fov_deg = 180\n", "line 5, column 20", "less than 180"},
        {"[[material]]\nname = 'a'\nroughness = 0.5\nshininess = 3\n", "line 5, column 13",
         "a material must be one or the other"},
        {"[fog]\nkind = 'linear'\nstart = 5\nend = 5\n", "line 6, column 7", "'end' must be more"},
        {"[render]\n--engine = 'soft'\n", "line 4, column 1", "without dashes"},
        {"[render]\nresolution = [[1], 2]\n", "line 4, column 15", "not an array"},
        {"[render]\nwhen = 2020-01-01\n", "line 4, column 8", "not a date"},
        {"a = [1, 2\n", "line 3, column 11", ""},
        {"x = 'open\n", "line 3, column 10", ""},
        {"[fog]\nkind = 'exp'\nkind = 'exp'\n", "line 5, column 8", "redefine"},
        {"[=]\n", "line 3, column 2", "not TOML"},  // toml++ asserts these three
        {"[.[light]]\n", "line 3, column 2", "not TOML"},
        {"[[.5, 1]\n", "line 3, column 3", "not TOML"},
        {"[[material]]\nname = 'a'\nmodel = 'teapot'\nshading = 'flatt'\n", "line 6, column 11",
         "unknown word 'flatt'"},
        {"[[material]]\nname = 'a'\n[[material]]\nname = 'a'\n", "line 5, column 1", "second [[material]] named 'a'"},
        {"[[primitive]]\ntype = 'cone'\nmaterial = 'a'\n[[material]]\nname = 'a'\n[[material]]\nname = 'a'\nmodel "
         "= 'teapot'\n",
         "line 8, column 1", "uses as its 'material'"},
        {"[[material]]\nname = 'a'\nbump_steps = [30, 4]\n", "line 5, column 14", "not be more than the second"},
        {"[[material]]\nname = 'a'\nbump_steps = [4, 8.5]\n", "line 5, column 18", "two whole numbers"},
        {"[[material]]\nname = 'a'\ncolor = [2e30, 1, 1]\n", "line 5, column 10", "at least 0 and at most 1e+30"},
        {"[fog]\nkind = 'exp'\nstart = 2\n", "line 5, column 9", "of kind 'exp' has no 'start'"},
        {"[fog]\nkind = 'linear'\ndensity = 2\n", "line 5, column 11", "of kind 'linear' has no 'density'"},
        {"y = 99999999999999999999\n", "line 3, column", ""},
    };
    for (const auto& [text, place, words] : faults) {
        const Error error = error_of([&] { with_teapot(text); });
        EXPECT_EQ(error.code(), ErrorCode::bad_file) << text;
        EXPECT_EQ(error.place().substr(0, std::string_view(place).size()), place) << text << error.what();
        EXPECT_NE(error.reason().find(words), std::string::npos) << text << error.what();
    }
}

TEST(ParseWorld, AMisspeltWordIsSaidWithTheNearest) {
    EXPECT_EQ(error_of([] { with_teapot("[[model]]\nfile = 'a'\npostion = [0, 0, 0]\n"); }).advice(),
              "did you mean 'position'?");
    EXPECT_EQ(error_of([] { with_teapot("[[material]]\nname = 'a'\nlighting = 'blin-phong'\n"); }).advice(),
              "did you mean 'blinn-phong'?");
    EXPECT_EQ(error_of([] { with_teapot("[[camra]]\n"); }).advice(), "did you mean 'camera'?");
}

TEST(ParseWorld, AnEmptyWorldAndTooManyEntriesAreRefused) {
    EXPECT_EQ(error_of([] { parse_world(""); }).place(), "line 1, column 1");
    std::string many;
    for (int i = 0; i <= 10'000; ++i) many += "[[camera]]\nposition=[1,1,1]\n";
    EXPECT_NE(error_of([&] { with_teapot(many); }).reason().find("more than 10000"), std::string::npos);
    EXPECT_NE(error_of([] { parse_world(std::string((4u << 20) + 1, '\n')); }).reason().find("4 MiB"),
              std::string::npos);
}

TEST(ParseWorld, TheSameMaterialOfTwoModelsMayBeChangedApart) {
    EXPECT_EQ(with_teapot("[[material]]\nname = 'a'\n[[material]]\nname = 'a'\nmodel = 'teapot'\n").materials.size(),
              2u);
}

TEST(ParseWorld, DotsCountInKeysOnly) {
    const std::string dots(100, '.'), key = "[[light]]\ntype = 'ambient'\nambient = [0.5, 0.5, 0.5]\nname = ";
    const std::string texts[] = {"# " + dots + "\n", key + "'" + dots + "'\n", key + "\"\\\"" + dots + "\"\n",
                                 key + "'''a\n#'" + dots + "'''\n",
                                 key + "\"\"\"\"a\"\" " + dots + "\"\"\"\"\" # " + dots + "\n"};
    for (const std::string& text : texts) EXPECT_EQ(with_teapot(text).models.size(), 0u) << text;
}

TEST(ParseWorld, NoStringHidesAKeyOfManyDots) {
    std::string dotted = "a";
    for (int i = 0; i < 100'000; ++i) dotted += ".a";
    for (const char* before : {"b = 'c'\n", "b = \"\\\"\" # '\n", "b = \"\"\n", "b = \"\"\"c\"\"\"\"\"\n",
                               "b = \'\'\'c\'\'\'\'\n", "'b'.", "\"'\".", "# \"\"\"\n", "# '\n"})
        EXPECT_EQ(error_of([&] { with_teapot(before + dotted + " = 1\n"); }).reason(), "a key of more than 64 parts")
            << before;
}

TEST(ParseWorld, TablesInsideOneAnotherDoNotExhaustTheStack) {
    EXPECT_EQ(error_of([] { with_teapot("a = " + std::string(100'000, '[')); }).code(), ErrorCode::bad_file);
    std::string dotted = "a";
    for (int i = 0; i < 100'000; ++i) dotted += ".a";
    EXPECT_EQ(error_of([&] { with_teapot(dotted + " = 1\n"); }).code(), ErrorCode::bad_file);
    EXPECT_EQ(error_of([&] { with_teapot("[" + dotted + "]\n"); }).code(), ErrorCode::bad_file);
}

TEST(ParseWorld, ATeapotHasDivisionsOrATolerance) {
    EXPECT_EQ(parse_world("[[primitive]]\ntype = 'teapot'\ntolerance = 0.01\n").primitives[0].tolerance, 0.01);
    EXPECT_EQ(
        error_of([] { parse_world("[[primitive]]\ntype = 'teapot'\ndivisions = 9\ntolerance = 0.01\n"); }).place(),
        "line 4, column 13");
}

TEST(ShapeWords, AreThoseOfAPrimitive) {
    const WorldPrimitive torus = shape_of_words("torus:tolerance=0.01:radius=2:tube_radius=0.5:objects=4");
    EXPECT_EQ(torus.type, "torus");
    EXPECT_EQ(torus.tolerance, 0.01);
    EXPECT_EQ(torus.radius, 2);
    EXPECT_EQ(torus.tube_radius, 0.5);
    EXPECT_EQ(torus.objects, 4);
    const WorldPrimitive plane = shape_of_words("plane:size=3,4:divisions=5");
    EXPECT_EQ(plane.width, 3);
    EXPECT_EQ(plane.depth, 4);
    EXPECT_EQ(plane.divisions, 5);
    EXPECT_EQ(shape_of_words("teapot").divisions, 10);
}

TEST(ShapeWords, AWrongValueIsRefusedWithWhatWouldBeRightOnACommandLine) {
    const std::string wanted = "'size' must be two numbers, as in size=2,3, not ";
    for (const std::string wrong : {"4", "[2,3]", "2,3,4", "a,b", "2,"}) {
        const Error error = error_of([&] { shape_of_words("plane:size=" + wrong); });
        EXPECT_EQ(error.reason(), wanted + "'" + wrong + "'");
        EXPECT_EQ(error.code(), ErrorCode::usage);
    }
    EXPECT_EQ(error_of([] { shape_of_words("plane:divisions=2,3"); }).reason(),
              "'divisions' must be a whole number, not '2,3'");
    const Error color = error_of([] { material_values(std::vector<std::string>{"color=[1,0,0]"}); });
    EXPECT_EQ(color.reason(),
              "'color' must be three numbers, as in color=1,0.5,0, or a code or name, as in color=#ff8000, not "
              "'[1,0,0]'");
}

TEST(ShapeWords, WhatIsNoKeyOfAShapeIsRefusedByItsName) {
    const std::pair<const char*, const char*> wrong[] = {
        {"sphere:tolernce=1", "unknown key 'tolernce'"},
        {"sphere:position=1,2,3", "unknown key 'position'"},
        {"sphere:radius", "'radius' is not KEY=VALUE"},
        {"sphere:", "'' is not KEY=VALUE"},
        {"sphere:radius=x", "'radius'"},
        {"sphere:radius=-1", "'radius'"},
        {"sphere:radius=1:radius=2", "given twice"},
        {"cone:tube_radius=1", "a cone has no 'tube_radius'"},
        {"cube", "'type'"},
        {"teapot:divisions=4:tolerance=1", "either 'divisions' or 'tolerance'"}};
    for (const auto& [words, reason] : wrong) {
        const Error error = error_of([&] { shape_of_words(words); });
        EXPECT_EQ(error.code(), ErrorCode::usage) << words;
        EXPECT_NE(error.reason().find(reason), std::string::npos) << words << ": " << error.reason();
    }
}
