// SPDX-License-Identifier: Apache-2.0
// Lighting models of the user's own as a value of the key `lighting`.
#include "world/keys/lighting_text.h"

#include <gtest/gtest.h>

#include <fstream>

#include <rakelight/world/render_keys.h>
#include <rakelight/world/world_request.h>
#include <rakelight_internal/world/settings_file.h>

#include "support/temporary_folder.h"
#include "support/thrown_error.h"

namespace rakelight {
namespace {

constexpr const char* text =
    "RL_FN LightTerms user_terms(RL_IN(MaterialSurface) s, RL_IN(LightSample) light) { return no_terms(); }\n";

PictureRequest read(const std::string& word) {
    PictureRequest request;
    const WorldValue value{.key = "lighting", .words = {word}};
    read_render_keys({&value, 1}, request);
    return request;
}

TEST(LightingText, AFileTravelsAsItsTextAndIsWrittenByItsName) {
    const test::TemporaryFolder folder;
    const std::string file = folder.write("steps.glsl", text);
    const PictureRequest request = read(file);
    EXPECT_EQ(request.settings.lighting_text, text);
    EXPECT_EQ(request.settings.lighting_name, file);
    EXPECT_EQ(request.settings.lighting, Lighting::automatic);
    const std::vector<WorldValue> written = written_render_keys(request);
    ASSERT_EQ(written.size(), 1u);
    EXPECT_EQ(written[0].words, std::vector<std::string>{file});
}

TEST(LightingText, AWordTakesThePlaceOfAFile) {
    const test::TemporaryFolder folder;
    PictureRequest request = read(folder.write("steps.glsl", text));
    const WorldValue word{.key = "lighting", .words = {"ward"}};
    read_render_keys({&word, 1}, request);
    EXPECT_EQ(request.settings.lighting, Lighting::ward);
    EXPECT_TRUE(request.settings.lighting_text.empty() && request.settings.lighting_name.empty());
}

TEST(LightingText, WhatIsNoFileOrNoModelIsRefused) {
    const test::TemporaryFolder folder;
    const Error missing = test::error_of([&] { read((folder.path() / "no.glsl").string()); });
    EXPECT_EQ(missing.code(), ErrorCode::not_found);
    EXPECT_EQ(missing.setting(), "lighting");
    const std::string other = folder.write("other.glsl", "float f() { return 1.0; }\n");
    EXPECT_EQ(test::error_of([&] { read(other); }).code(), ErrorCode::bad_file);
    const std::string large = folder.write("large.glsl", text + std::string(1100000, ' '));
    EXPECT_NE(test::error_of([&] { read(large); }).reason().find("more than"), std::string::npos);
    EXPECT_EQ(test::error_of([&] { read("toon"); }).code(), ErrorCode::usage) << "no word, and no file's name";
}

TEST(LightingText, AWorldNamesItFromItsFolderAndNotBeyond) {
    const test::TemporaryFolder folder;
    folder.write("steps.glsl", text);
    const std::string inside =
        folder.write("a.scene.toml", "[[primitive]]\ntype = \"sphere\"\n[render]\nlighting = \"steps.glsl\"\n");
    Context context;
    EXPECT_EQ(request_of_world(inside, {.allow_shaders = true}, context).settings.lighting_text, text);
    folder.write("in/b.scene.toml", "[[primitive]]\ntype = \"sphere\"\n[render]\nlighting = \"../steps.glsl\"\n");
    const Error error = test::error_of(
        [&] { request_of_world((folder.path() / "in/b.scene.toml").string(), {.allow_shaders = true}, context); });
    EXPECT_EQ(error.code(), ErrorCode::bad_file) << error.what();
    EXPECT_NE(error.reason().find("leaves"), std::string::npos) << error.what();
}

TEST(LightingText, AWorldNamesGlslOnlyWhereThatIsAllowed) {
    const test::TemporaryFolder folder;
    folder.write("steps.glsl", text);
    Context context;
    for (const char* const key : {"lighting", "vertex-shader"}) {
        const std::string world = folder.write(
            "a.scene.toml", "[[primitive]]\ntype = \"sphere\"\n[render]\n" + std::string(key) + " = \"steps.glsl\"\n");
        const Error error = test::error_of([&] { request_of_world(world, {}, context); });
        EXPECT_EQ(error.code(), ErrorCode::bad_file);
        EXPECT_EQ(error.place(), "line 4, column 1") << error.what();
        EXPECT_EQ(error.setting(), key);
        EXPECT_EQ(error.related(), std::vector<std::string>{"allow-shaders"});
    }
    const std::string plain =
        folder.write("b.scene.toml", "[[primitive]]\ntype = \"sphere\"\n[render]\nlighting = \"ward\"\n");
    EXPECT_EQ(request_of_world(plain, {}, context).settings.lighting, Lighting::ward) << "a word names no file";
}

TEST(LightingText, WhatTheCallerGivesNeedsNoPermission) {
    const test::TemporaryFolder folder;
    const std::string mine = folder.write("mine.glsl", text);
    const std::string world =
        folder.write("a.scene.toml", "[[primitive]]\ntype = \"sphere\"\n[render]\nlighting = \"other.glsl\"\n");
    Context context;
    const WorldRequest request =
        read_world_request(world, {}, {.values = {{.key = "lighting", .words = {mine}}}}, context);
    EXPECT_EQ(request.picture.settings.lighting_name, mine) << "that of the world is not read";
}

TEST(LightingText, SettingsOfTheUsersOwnMayNameGlslButNotThoseInAWorld) {
    const test::TemporaryFolder folder;
    folder.write("steps.glsl", text);
    Context context;
    const char* const render = "[render]\nlighting = \"steps.glsl\"\n";
    const std::string own = folder.write("mine.toml", render), world = folder.write("a.scene.toml", render);
    const WorldRequest request = read_settings_file(own, {}, {}, context);
    EXPECT_EQ(request.picture.settings.lighting_text, text);
    EXPECT_FALSE(request.picture.load.allow_shaders) << "it permits nothing to the worlds that are drawn";
    EXPECT_EQ(test::error_of([&] { read_settings_file(world, {}, {}, context); }).related(),
              std::vector<std::string>{"allow-shaders"});
}

constexpr const char* moving =
    "uniform float height;\nuniform vec3 tint = vec3(1.0);\nvoid user_vertex(inout Vertex v) {}\n";

PictureRequest read_uniforms(const test::TemporaryFolder& folder, std::vector<std::string> words) {
    PictureRequest request;
    const std::vector<WorldValue> values{{.key = "vertex-shader", .words = {folder.file("move.glsl")}},
                                         {.key = "uniform", .words = std::move(words)}};
    read_render_keys(values, request);
    return request;
}

TEST(UniformKey, TakesNumbersAndVectorsByName) {
    const test::TemporaryFolder folder;
    folder.write("move.glsl", moving);
    const PictureRequest request = read_uniforms(folder, {"height=1.5e-3", "tint=1,-0.5,0"});
    ASSERT_EQ(request.settings.uniforms.size(), 2u);
    EXPECT_EQ(request.settings.uniforms[0], (ShaderUniform{"height", {1.5e-3f}}));
    EXPECT_EQ(request.settings.uniforms[1], (ShaderUniform{"tint", {1, -0.5f, 0}}));
    EXPECT_EQ(request.settings.vertex_text, moving);
}

TEST(UniformKey, WhatDoesNotFitIsOneLineAboutIt) {
    const test::TemporaryFolder folder;
    folder.write("move.glsl", moving);
    for (const char* const word : {"height", "=1", "height=", "height=high", "height=1,", "height=inf", "height=nan",
                                   "height=1e39", "height=1,2", "tint=1", "tint=1,2,3,4,5", "hieght=1"}) {
        const Error error = test::error_of([&] { read_uniforms(folder, {word}); });
        EXPECT_EQ(error.code(), ErrorCode::usage) << word;
        EXPECT_EQ(error.setting(), "uniform") << word;
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
    EXPECT_EQ(test::error_of([&] { read_uniforms(folder, {"height=1", "height=2"}); }).setting(), "uniform");
    EXPECT_EQ(test::error_of([&] { read_uniforms(folder, std::vector<std::string>(65, "height=1")); }).setting(),
              "uniform");
}

TEST(UniformKey, AWorldGivesValuesAndNamesTheFileFromItsFolder) {
    const test::TemporaryFolder folder;
    folder.write("move.glsl", moving);
    const std::string world = folder.write("a.scene.toml",
                                           "[[primitive]]\ntype = \"plane\"\n[render]\nvertex-shader = \"move.glsl\"\n"
                                           "uniform = [\"height=0.5\", \"tint=0,0,1\"]\n");
    Context context;
    const LoadOptions allowing{.allow_shaders = true};
    const RenderSettings settings = request_of_world(world, allowing, context).settings;
    EXPECT_EQ(settings.vertex_text, moving);
    ASSERT_EQ(settings.uniforms.size(), 2u);
    EXPECT_EQ(settings.uniforms[1], (ShaderUniform{"tint", {0, 0, 1}}));
    const std::string wrong = folder.write(
        "b.scene.toml",
        "[[primitive]]\ntype = \"plane\"\n[render]\nvertex-shader = \"move.glsl\"\nuniform = [\"width=0.5\"]\n");
    const Error error = test::error_of([&] { request_of_world(wrong, allowing, context); });
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    EXPECT_NE(error.place().find("line 5"), std::string::npos) << error.what();
}

}  // namespace
}  // namespace rakelight
