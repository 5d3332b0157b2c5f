// SPDX-License-Identifier: Apache-2.0
#include <rakelight_internal/io/folder_lock.h>

#include <gtest/gtest.h>

#include <rakelight/base/error.h>

#include <filesystem>
#include <optional>

#include "support/temporary_folder.h"
#include "support/thrown_error.h"

namespace rakelight {
namespace {

namespace fs = std::filesystem;
using test::error_of;

TEST(FolderLocks, AreHeldByOneAtATime) {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("frames");
    std::optional<FolderLock> first(path);
    const Error error = error_of([&] { const FolderLock second(path); });
    EXPECT_EQ(error.code(), ErrorCode::failed);
    EXPECT_EQ(error.file(), path);
    first.reset();
    EXPECT_NO_THROW(const FolderLock again(path));
}

TEST(FolderLocks, FoldersThatWereMadeGoAgainUnlessSomethingIsInThem) {
    const test::TemporaryFolder folder;
    { const FolderLock lock(folder.file("a/b")); }
    EXPECT_TRUE(folder.is_empty());
    {
        const FolderLock lock(folder.file("a/b"));
        folder.write("a/b/frame", "");
    }
    EXPECT_TRUE(fs::exists(folder / "a/b/frame"));
    fs::remove(folder / "a/b/frame");
    { const FolderLock lock(folder.file("a/b")); }
    EXPECT_TRUE(fs::exists(folder / "a/b")) << "it was there before";
}

TEST(FolderLocks, AFolderThatWasReplacedIsAnotherOne) {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("frames");
    const FolderLock first(path);
    fs::remove(path);
    EXPECT_NO_THROW(const FolderLock second(path));
}

TEST(FolderLocks, WhatIsNoFolderIsRefused) {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("file", "");
    EXPECT_EQ(error_of([&] { const FolderLock lock(path); }).code(), ErrorCode::failed);
}

}  // namespace
}  // namespace rakelight
