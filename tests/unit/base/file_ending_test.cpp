// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <rakelight_internal/base/file_ending.h>

using rakelight::file_ending;

TEST(FileEnding, IsInLowerCaseAndWithoutItsDot) {
    EXPECT_EQ(file_ending("a.glb"), "glb");
    EXPECT_EQ(file_ending("folder/OUT.GLTF"), "gltf");
    EXPECT_EQ(file_ending("x.Scene.ToMl"), "toml");
    EXPECT_EQ(file_ending("scan.001.Ply"), "ply");
}

TEST(FileEnding, IsThatOfTheFileNotOfItsFolders) {
    EXPECT_EQ(file_ending("v1.2/model"), "");
    EXPECT_EQ(file_ending("v1.2/"), "");
    EXPECT_EQ(file_ending("v1.2/model.OBJ"), "obj");
    EXPECT_EQ(file_ending("../model"), "");
}

TEST(FileEnding, IsEmptyForNamesWithoutOne) {
    for (const char* const name : {"", ".", "..", "/", "name", ".png", "out/.png", "name."})
        EXPECT_EQ(file_ending(name), "") << name;
}

TEST(FileEnding, LeavesOtherBytesAsTheyAre) { EXPECT_EQ(file_ending("a.\xC3\x84\x5B@Z"), "\xC3\x84\x5B@z"); }
