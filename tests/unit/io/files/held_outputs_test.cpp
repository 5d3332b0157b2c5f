// SPDX-License-Identifier: Apache-2.0
// Several outputs that appear together or not at all.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "io/files/beside.h"
#include "io/files/held_outputs.h"
#include "support/temporary_folder.h"
#include "support/thrown_error.h"

namespace rakelight::io {
namespace {

namespace fs = std::filesystem;

class HeldOutputsTest : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder_.file(name); }
    void put(const std::string& name, const std::string& text) const {
        write_file(path(name), std::as_bytes(std::span(text.data(), text.size())));
    }
    std::string text_of(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream(path(name)).rdbuf();
        return text.str();
    }
    /// Files and folders, temporary ones too.
    std::size_t entries() const {
        return std::size_t(std::distance(fs::recursive_directory_iterator(folder_.path()), {}));
    }
    test::TemporaryFolder folder_;
};

TEST_F(HeldOutputsTest, AppearWhenTheyAreCommitted) {
    HeldOutputs held;
    put("a", "one");
    put("deep/b", "two");
    EXPECT_FALSE(fs::exists(path("a")) || fs::exists(path("deep/b")));
    held.commit();
    EXPECT_EQ(text_of("a") + text_of("deep/b"), "onetwo");
    EXPECT_EQ(entries(), 3u);
}

TEST_F(HeldOutputsTest, LeaveNothingWhenTheyAreNot) {
    put("a", "old");
    {
        HeldOutputs held;
        put("a", "one");
        put("deep/er/b", "two");
    }
    EXPECT_EQ(text_of("a"), "old");
    EXPECT_EQ(entries(), 1u);
    put("a", "new");  // and files are written as ever again
    EXPECT_EQ(text_of("a"), "new");
}

TEST_F(HeldOutputsTest, GetTheirOldContentBackWhereOneCannotBeRenamed) {
    put("a", "old");
    {
        HeldOutputs held;
        put("a", "one");
        put("b", "two");
        put("c", "three");
        fs::create_directories(path("c/taken"));  // since it was written
        const Error error = test::error_of([&] { held.commit(); });
        EXPECT_EQ(error.code(), ErrorCode::failed);
        EXPECT_EQ(error.file(), path("c"));
    }
    EXPECT_EQ(text_of("a"), "old");
    EXPECT_FALSE(fs::exists(path("b")));
    fs::remove_all(path("c"));
    EXPECT_EQ(entries(), 1u);
}

TEST_F(HeldOutputsTest, MayBeOneFileTwiceButNotWithOtherBytes) {
    fs::create_directory(path("x"));
    {
        HeldOutputs held;
        put("texture", "the same");
        put("x/../texture", "the same");
        held.commit();
    }
    EXPECT_EQ(text_of("texture"), "the same");
    {
        HeldOutputs held;
        put("texture", "one");
        EXPECT_EQ(test::error_of([&] { put("texture", "two"); }).code(), ErrorCode::failed);
    }
    EXPECT_EQ(text_of("texture"), "the same");
    EXPECT_EQ(entries(), 2u);
}

TEST_F(HeldOutputsTest, ReplaceFilesThroughLinks) {
    put("real", "old");
    fs::create_symlink("real", path("link"));
    HeldOutputs held;
    put("link", "new");
    put("b", "two");
    EXPECT_EQ(text_of("real"), "old");
    held.commit();
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(text_of("real"), "new");
}

}  // namespace
}  // namespace rakelight::io
