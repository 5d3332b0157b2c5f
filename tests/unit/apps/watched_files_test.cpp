// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/common/watched_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "support/temporary_folder.h"

namespace rakelight::apps {
namespace {

class Watched : public testing::Test {
protected:
    /// As if it had been written so many seconds later.
    std::string write(const std::string& name, int seconds) {
        const std::string path = folder_.write(name, name);
        std::filesystem::last_write_time(path, begin_ + std::chrono::seconds(seconds));
        return path;
    }
    test::TemporaryFolder folder_;
    const std::filesystem::file_time_type begin_ = std::filesystem::file_time_type::clock::now();
    const std::string model_ = write("a.gltf", 0), beside_ = write("a.bin", 0);
    WatchedFiles files_;
};

TEST_F(Watched, OneThatHasChangedAndStaysIsNews) {
    files_.begin(model_);
    files_.take({model_, beside_});
    EXPECT_FALSE(files_.has_changed());
    write("a.bin", 1);
    EXPECT_FALSE(files_.has_changed()) << "it may be half written";
    write("a.gltf", 1);
    EXPECT_FALSE(files_.has_changed()) << "the other one is being written";
    EXPECT_TRUE(files_.has_changed());
    files_.begin(model_);
    files_.take({beside_, model_});
    EXPECT_FALSE(files_.has_changed());
}

TEST_F(Watched, AChangeWhileTheyAreReadIsNotMissed) {
    files_.begin(model_);
    files_.take({beside_});
    files_.begin(model_);
    write("a.bin", 1);
    files_.take({beside_});
    EXPECT_FALSE(files_.has_changed());
    EXPECT_TRUE(files_.has_changed());
}

TEST_F(Watched, AChangeWhileAllIsReadForTheFirstTimeIsNotMissed) {
    files_.begin(model_);
    write("a.bin", 1);
    files_.take({model_, beside_});
    EXPECT_FALSE(files_.has_changed());
    EXPECT_TRUE(files_.has_changed());
}

TEST_F(Watched, PicturesOfALookAreWatchedFromWhenTheyAreNamed) {
    const std::string picture = write("p.png", 0);
    files_.begin(model_);
    files_.take({beside_});
    files_.add({picture, beside_});
    files_.add({picture});
    EXPECT_FALSE(files_.has_changed() || files_.has_changed());
    write("p.png", 1);
    files_.has_changed();
    files_.add({picture});
    EXPECT_TRUE(files_.has_changed());
}

TEST_F(Watched, AFileThatCannotBeReadIsNotReadAgainAndAgain) {
    files_.begin(model_);
    files_.take({beside_});
    write("a.bin", 1);
    files_.begin(model_);  // and it failed: nothing is taken
    EXPECT_FALSE(files_.has_changed());
    EXPECT_FALSE(files_.has_changed());
    write("a.bin", 2);
    files_.has_changed();
    EXPECT_TRUE(files_.has_changed());
}

TEST_F(Watched, MissingFilesAreWaitedFor) {
    files_.begin(model_);
    files_.take({beside_, folder_.file("missing.png")});
    std::filesystem::remove(beside_);
    EXPECT_FALSE(files_.has_changed());
    EXPECT_FALSE(files_.has_changed());
    write("missing.png", 1);
    files_.has_changed();
    EXPECT_TRUE(files_.has_changed());
}

TEST_F(Watched, ManyAreLookedAtAFewAtATime) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < WatchedFiles::at_once; ++i) names.push_back(write("t" + std::to_string(i), 0));
    files_.begin(model_);
    files_.take(names);
    write("t" + std::to_string(names.size() - 1), 1);  // the last one
    int looks = 1;
    while (!files_.has_changed() && looks < 10) ++looks;
    EXPECT_GT(looks, 2);
    EXPECT_LT(looks, 5);
}

TEST_F(Watched, WaitingEndsWithTheChangeAndKnowsItThen) {
    const std::string picture = write("p.png", 0);
    files_.begin(model_);
    files_.add({picture, beside_});
    EXPECT_EQ(files_.count(), 3u);
    write("p.png", 1);
    EXPECT_EQ(files_.wait(), picture);
    EXPECT_FALSE(files_.has_changed() || files_.has_changed());
}

TEST_F(Watched, WhatIsWrittenAfterReadingBeganHasChanged) {
    files_.begin(model_);
    write("a.bin", 1);
    files_.add({beside_}, begin_);
    EXPECT_EQ(files_.wait(), beside_);
}

TEST_F(Watched, NoMoreThanTheMostAreWatched) {
    WatchedFiles two(2);
    two.add({model_});
    EXPECT_EQ(two.count(), 0u) << "not begun";
    two.begin(model_);
    two.add({beside_, write("p.png", 0)});
    EXPECT_EQ(two.count(), 2u);
}

}  // namespace
}  // namespace rakelight::apps
