// SPDX-License-Identifier: Apache-2.0
// Lighting models of the user's own as a value of the key `lighting`.
#include "world/lighting_text.h"

#include <gtest/gtest.h>

#include <fstream>

#include <rakelight/request.h>

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
    const std::string large = folder.write("large.glsl", std::string(1100000, ' ') + text);
    EXPECT_NE(test::error_of([&] { read(large); }).reason().find("more than"), std::string::npos);
    EXPECT_EQ(test::error_of([&] { read("toon"); }).code(), ErrorCode::usage) << "no word, and no file's name";
}

TEST(LightingText, AWorldNamesItFromItsFolderAndNotBeyond) {
    const test::TemporaryFolder folder;
    folder.write("steps.glsl", text);
    const std::string inside =
        folder.write("a.scene.toml", "[[primitive]]\ntype = \"sphere\"\n[render]\nlighting = \"steps.glsl\"\n");
    Context context;
    EXPECT_EQ(request_of_world(inside, {}, context).settings.lighting_text, text);
    folder.write("in/b.scene.toml", "[[primitive]]\ntype = \"sphere\"\n[render]\nlighting = \"../steps.glsl\"\n");
    const Error error =
        test::error_of([&] { request_of_world((folder.path() / "in/b.scene.toml").string(), {}, context); });
    EXPECT_EQ(error.code(), ErrorCode::bad_file) << error.what();
}

}  // namespace
}  // namespace rakelight
