// SPDX-License-Identifier: Apache-2.0
// The folder of `stages`: what is on the disk when it gets its name.
#include "tools/stages/folder.h"

#include <gtest/gtest.h>
#include <rakelight_internal/io/unfinished_outputs.h>

#include <fstream>

#include "support/recorded_syncs.h"
#include "support/thrown_error.h"
#include "unit/io/pictures/image_io_support.h"

namespace rakelight::stages {
namespace {

namespace fs = std::filesystem;
using Calls = std::vector<std::string>;

TEST(StagesFolder, EveryFileIsOnTheDiskBeforeTheFolderHasItsNameAndTheNameAfterIt) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder.file("here"));
    const test::RecordedSyncs recorded;
    NewFolder pages(folder.file("here/out"));
    pages.write("a.png", test::noise_picture(4, 4, 3, Component::u8));
    pages.write("index.html", "<p>");
    EXPECT_EQ(recorded.calls, Calls{"rename * a.png"});  // not one by one: the folder would be synced for each
    pages.finish();
    EXPECT_EQ(recorded.calls, (Calls{"rename * a.png", "sync a.png", "sync index.html", "sync stages.json", "sync *",
                                     "rename * out", "sync here"}));
}

TEST(StagesFolder, OneWhoseFilesDoNotReachTheDiskLeavesTheOneBefore) {
    const test::TemporaryFolder folder;
    const auto write = [&](const char* text) {
        NewFolder pages(folder.file("out"));
        pages.write("index.html", text);
        pages.finish();
    };
    write("old");
    test::RecordedSyncs recorded;
    recorded.fsync_error = [](const fs::path&) { return EIO; };
    EXPECT_EQ(test::error_of([&] { write("new"); }).code(), ErrorCode::failed);
    std::string text;
    std::getline(std::ifstream(folder.file("out/index.html")) >> std::ws, text);
    EXPECT_EQ(text, "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.file(".")), fs::directory_iterator()), 1);
}

TEST(StagesFolder, LinksToFoldersAreFollowedAlsoToOneThatIsNotThere) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder.file("real"));
    fs::create_directory(folder.file("real/empty"));
    fs::create_directory_symlink("real/empty", folder.file("to_empty"));
    fs::create_directory_symlink("real/new", folder.file("to_none"));
    for (const char* name : {"to_empty", "to_none", "to_none/"}) {
        NewFolder pages(folder.file(name));
        pages.write("index.html", "<p>");
        pages.finish();
    }
    EXPECT_TRUE(fs::is_symlink(folder.file("to_empty")) && fs::is_symlink(folder.file("to_none")));
    EXPECT_TRUE(fs::is_regular_file(folder.file("real/empty/index.html")));
    EXPECT_TRUE(fs::is_regular_file(folder.file("real/new/index.html")));
}

TEST(StagesFolder, AnEndByASignalLeavesNothingOfWhatIsUnfinished) {
    const test::TemporaryFolder folder;
    const auto count = [&](const fs::path& in) {
        return std::distance(fs::directory_iterator(in), fs::directory_iterator());
    };
    {
        NewFolder whole(folder.file("whole"));
        whole.write("index.html", "<p>");
        whole.finish();
        NewFolder half(folder.file("half"));
        half.write("a.png", test::noise_picture(4, 4, 3, Component::u8));
        half.write("index.html", "<p>");
        EXPECT_EQ(count(folder.path()), 2);
        remove_unfinished_outputs();
        EXPECT_EQ(count(folder.path()), 1);
    }
    EXPECT_EQ(count(folder.file("whole")), 2) << "index.html and the list";
}

}  // namespace
}  // namespace rakelight::stages
