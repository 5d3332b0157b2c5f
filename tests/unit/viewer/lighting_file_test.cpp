// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/lighting_file.h"

#include <gtest/gtest.h>

#include <chrono>

#include "support/temporary_folder.h"
#include "support/thrown_error.h"

namespace rakelight::viewer {
namespace {

class LightingFiles : public testing::Test {
protected:
    /// As if it had been written so many seconds later.
    void write(const std::string& text, int seconds) {
        folder_.write("mine.glsl", text);
        std::filesystem::last_write_time(file, begin_ + std::chrono::seconds(seconds));
    }
    test::TemporaryFolder folder_;
    const std::filesystem::file_time_type begin_ = std::filesystem::file_time_type::clock::now();

    const std::string file = folder_.file("mine.glsl");
    LightingFile watched;
};

TEST_F(LightingFiles, AreReadAgainOnceTheyStayAsTheyAre) {
    write("user_terms 1", 0);
    EXPECT_FALSE(watched.changed(file)) << "it was read by others";
    EXPECT_FALSE(watched.changed(file));
    write("user_terms 2", 1);
    EXPECT_FALSE(watched.changed(file)) << "it may be half written";
    EXPECT_EQ(watched.changed(file), "user_terms 2");
    EXPECT_FALSE(watched.changed(file));
}

TEST_F(LightingFiles, ThatAreNoLightingModelsAreToldOfOnce) {
    write("user_terms", 0);
    watched.changed(file);
    write("nothing", 1);
    EXPECT_FALSE(watched.changed(file));
    EXPECT_EQ(test::error_of([&] { watched.changed(file); }).code(), ErrorCode::bad_file);
    EXPECT_FALSE(watched.changed(file));
}

TEST_F(LightingFiles, ThatAreNotThereAreWaitedFor) {
    write("user_terms", 0);
    watched.changed(file);
    std::filesystem::remove(file);
    EXPECT_FALSE(watched.changed(file));
    EXPECT_FALSE(watched.changed(""));
    write("user_terms again", 1);
    EXPECT_FALSE(watched.changed(file));
    EXPECT_EQ(watched.changed(file), "user_terms again");
}

}  // namespace
}  // namespace rakelight::viewer
