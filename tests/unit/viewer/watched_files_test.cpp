// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/watched_files.h"

#include <algorithm>
#include <chrono>

#include "looks.h"
#include "support/shared.h"

namespace rakelight::viewer {
namespace {

class Watched : public Looks {
protected:
    /// As if it had been written so many seconds later.
    std::string write(const std::string& name, int seconds) {
        const std::string path = folder_.write(name, name);
        std::filesystem::last_write_time(path, begin_ + std::chrono::seconds(seconds));
        return path;
    }
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

TEST_F(Watched, AModelKnowsTheFilesThatItIsMadeOf) {
    folder_.write("m.mtl", "newmtl red\nmap_Kd red.png\n");
    std::filesystem::copy_file(test::source_dir() / "data/bricks/normal.png", folder_.file("red.png"));
    folder_.write("model.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl red\nf 1/1 2/1 3/1\n");
    folder_.write("one.scene.toml", "[[model]]\nfile = \"model.obj\"\n");
    const auto m = model(file("one.scene.toml"));
    for (const char* name : {"one.scene.toml", "model.obj", "m.mtl", "red.png"})
        EXPECT_NE(std::ranges::find(m->files, file(name)), m->files.end()) << name;
}

}  // namespace
}  // namespace rakelight::viewer
