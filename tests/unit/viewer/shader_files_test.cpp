// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/view/shader_files.h"

#include <gtest/gtest.h>

#include <chrono>

#include "support/temporary_folder.h"
#include "support/thrown_error.h"

namespace rakelight::viewer {
namespace {

class ShaderFilesTest : public testing::Test {
protected:
    /// As if it had been written so many seconds later.
    void write(const std::string& text, int seconds) {
        folder_.write("mine.glsl", text);
        std::filesystem::last_write_time(file, begin_ + std::chrono::seconds(seconds));
    }
    test::TemporaryFolder folder_;
    const std::filesystem::file_time_type begin_ = std::filesystem::file_time_type::clock::now();

    const std::string file = folder_.file("mine.glsl");
    ShaderFiles watched;

    std::string known = "user_terms";  ///< the text that the settings have

    /// The lighting's text, once it has changed.
    std::optional<std::string> changed(const std::string& name) {
        RenderSettings settings;
        settings.lighting_name = name;
        if (!name.empty()) settings.lighting_text = known;
        const std::optional<ShaderFiles::Texts> texts = watched.changed(settings);
        if (!texts) return std::nullopt;
        return known = texts->lighting;
    }
};

TEST_F(ShaderFilesTest, AreReadAgainOnceTheyStayAsTheyAre) {
    write("user_terms", 0);
    EXPECT_FALSE(changed(file)) << "it was read by others";
    EXPECT_FALSE(changed(file));
    write("user_terms 2", 1);
    EXPECT_FALSE(changed(file)) << "it may be half written";
    EXPECT_EQ(changed(file), "user_terms 2");
    EXPECT_FALSE(changed(file));
}

TEST_F(ShaderFilesTest, ThatChangeBeforeTheFirstLookAreReadAgain) {
    write("user_terms since then", 1);
    EXPECT_FALSE(changed(file));
    EXPECT_EQ(changed(file), "user_terms since then");
    EXPECT_FALSE(changed(file));
}

TEST_F(ShaderFilesTest, ThatAreNoLightingModelsAreToldOfOnce) {
    write("user_terms", 0);
    changed(file);
    write("nothing", 1);
    EXPECT_FALSE(changed(file));
    EXPECT_EQ(test::error_of([&] { changed(file); }).code(), ErrorCode::bad_file);
    EXPECT_FALSE(changed(file));
}

TEST_F(ShaderFilesTest, ThatAreNotThereAreWaitedFor) {
    write("user_terms", 0);
    changed(file);
    std::filesystem::remove(file);
    EXPECT_FALSE(changed(file));
    EXPECT_FALSE(changed(""));
    write("user_terms again", 1);
    EXPECT_FALSE(changed(file));
    EXPECT_EQ(changed(file), "user_terms again");
}

TEST_F(ShaderFilesTest, BothAreReadAgainWhenTheVertexShaderChanges) {
    folder_.write("light.glsl", "in vec3 a; // user_terms");
    write("out vec3 a; // user_vertex", 0);
    RenderSettings settings;
    settings.lighting_name = folder_.file("light.glsl"), settings.vertex_name = file;
    settings.lighting_text = "in vec3 a; // user_terms", settings.vertex_text = "out vec3 a; // user_vertex";
    for (int look = 0; look < 3; ++look) EXPECT_FALSE(watched.changed(settings)) << look;
    write("out vec3 a, b; // user_vertex", 1);
    EXPECT_FALSE(watched.changed(settings));
    const std::optional<ShaderFiles::Texts> texts = watched.changed(settings);
    ASSERT_TRUE(texts);
    EXPECT_EQ(texts->vertex, "out vec3 a, b; // user_vertex");
    EXPECT_EQ(texts->lighting, "in vec3 a; // user_terms");
}

}  // namespace
}  // namespace rakelight::viewer
