// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/document/display_path.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "support/temporary_folder.h"

namespace rakelight::viewer {
namespace {

namespace fs = std::filesystem;

/// In a working folder beside a home folder.
class ShownPath : public testing::Test {
protected:
    void SetUp() override {
        before_ = fs::current_path();
        if (const char* const home = std::getenv("HOME")) home_before_ = home;
        fs::create_directories(folder_.path() / "here");
        root_ = fs::canonical(folder_.path()).string();
        fs::current_path(root_ + "/here");
        setenv("HOME", (root_ + "/home").c_str(), 1);
    }
    void TearDown() override {
        fs::current_path(before_);
        setenv("HOME", home_before_.c_str(), 1);
    }
    test::TemporaryFolder folder_;
    fs::path before_;
    std::string root_, home_before_;
};

TEST_F(ShownPath, IsFromTheWorkingFolderOrTheHomeFolder) {
    EXPECT_EQ(display_path(root_ + "/here/a/b.glb"), "a/b.glb");
    EXPECT_EQ(display_path(root_ + "/home/models/b.glb"), "~/models/b.glb");
    EXPECT_EQ(display_path("a/b.glb"), "a/b.glb");
    EXPECT_EQ(display_path("builtin:teapot"), "builtin:teapot");
}

TEST_F(ShownPath, IsTheNameAloneElsewhere) {
    EXPECT_EQ(display_path(root_ + "/elsewhere/b.glb"), "b.glb");
    EXPECT_EQ(short_path(root_ + "/elsewhere/b.glb"), root_ + "/elsewhere/b.glb");
    EXPECT_EQ(display_path(root_ + "/hereabouts/b.glb"), "b.glb");  // no part of /here
}

TEST_F(ShownPath, TextsAreShortenedWhereAPathBegins) {
    const std::string model = root_ + "/elsewhere/b.glb";
    EXPECT_EQ(with_short_paths(model + ": bad\n  map  " + root_ + "/elsewhere/t.png", model),
              "b.glb: bad\n  map  t.png");
    EXPECT_EQ(with_short_paths("'" + root_ + "/here/x.obj' is empty"), "'x.obj' is empty");
    EXPECT_EQ(with_short_paths("no path at all"), "no path at all");
}

}  // namespace
}  // namespace rakelight::viewer
