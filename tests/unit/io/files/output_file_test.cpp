// SPDX-License-Identifier: Apache-2.0
// Where output goes through symbolic links, and what is on the disk when it has its name.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <sstream>

#include "io/files/file.h"
#include "io/files/output_file.h"
#include "support/recorded_syncs.h"
#include "support/thrown_error.h"
#include "unit/io/pictures/image_io_support.h"

namespace rakelight::io {
namespace {

namespace fs = std::filesystem;
using test::error_of;
using test::RecordedSyncs;
using Calls = std::vector<std::string>;

class OutputFileTest : public testing::Test {
protected:
    void SetUp() override { fs::create_directory(path("far")); }
    fs::path path(const std::string& name) const { return folder_ / name; }
    void link(const std::string& target, const std::string& name) const { fs::create_symlink(target, path(name)); }
    void put(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
    void write(const std::string& name, const std::string& text) const {
        OutputFile file(path(name).string());
        file.write(std::as_bytes(std::span(text.data(), text.size())));
        file.commit();
    }
    std::string text_of(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream(path(name)).rdbuf();
        return text.str();
    }
    std::size_t files_in(const std::string& name) const {
        return std::size_t(std::distance(fs::directory_iterator(path(name)), fs::directory_iterator()));
    }
    test::TemporaryFolder folder_;
};

TEST_F(OutputFileTest, ADanglingLinkGetsItsTarget) {
    link("far/new.txt", "alias");
    write("alias", "hello");
    EXPECT_TRUE(fs::is_symlink(path("alias")));
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(path("far/new.txt"))));
    EXPECT_EQ(text_of("far/new.txt"), "hello");
    EXPECT_EQ(files_in("far"), 1u);  // no temporary file
    write("alias", "again");
    EXPECT_EQ(text_of("far/new.txt"), "again");
}

TEST_F(OutputFileTest, AnAbsoluteDanglingLinkGetsItsTarget) {
    link(path("far/new.txt").string(), "alias");
    write("alias", "hello");
    EXPECT_TRUE(fs::is_symlink(path("alias")));
    EXPECT_EQ(text_of("far/new.txt"), "hello");
}

TEST_F(OutputFileTest, AChainOfLinksIsFollowedFromTheFolderOfEach) {
    link("far/second", "first");
    link("../third", "far/second");
    link("far/new.txt", "third");
    write("first", "hello");
    for (const char* name : {"first", "far/second", "third"}) EXPECT_TRUE(fs::is_symlink(path(name))) << name;
    EXPECT_EQ(text_of("far/new.txt"), "hello");
}

TEST_F(OutputFileTest, NothingAppearsBehindALinkBeforeItIsWhole) {
    link("far/new.txt", "alias");
    {
        OutputFile file(path("alias").string());
        EXPECT_FALSE(fs::exists(path("alias")));
        EXPECT_EQ(files_in("far"), 1u);  // the temporary file stands beside the target
    }
    EXPECT_EQ(files_in("far"), 0u);
    EXPECT_TRUE(fs::is_symlink(path("alias")));
}

TEST_F(OutputFileTest, LinksInACircleAreAnErrorAndStay) {
    link("b", "a");
    link("a", "b");
    link("self", "self");
    for (const char* name : {"a", "b", "self"}) {
        const Error error = error_of([&] { write(name, "x"); });
        EXPECT_EQ(error.code(), ErrorCode::failed);
        EXPECT_EQ(error.reason(), "cannot be written: Too many levels of symbolic links");
        EXPECT_EQ(error.file(), path(name).string());
        EXPECT_TRUE(fs::is_symlink(path(name)));
    }
}

TEST_F(OutputFileTest, ALinkToAFolderIsAnError) {
    link("far", "alias");
    EXPECT_EQ(error_of([&] { write("alias", "x"); }).reason(), "cannot be written: Is a directory");
    EXPECT_TRUE(fs::is_symlink(path("alias")));
}

TEST_F(OutputFileTest, ALinkIntoAFolderThatIsNotThereIsAnErrorThatNamesTheTarget) {
    link("absent/new.txt", "alias");
    const Error error = error_of([&] { write("alias", "x"); });
    EXPECT_EQ(error.reason(), "cannot be written: No such file or directory");
    EXPECT_EQ(error.file(), path("absent/new.txt").string());
    EXPECT_TRUE(fs::is_symlink(path("alias")));
}

TEST_F(OutputFileTest, ATargetThatIsThereKeepsItsPermissions) {
    put("far/old.txt", "old");
    fs::permissions(path("far/old.txt"), fs::perms::owner_read | fs::perms::owner_write);
    link("far/old.txt", "second");
    link("second", "first");
    write("first", "new");
    EXPECT_EQ(text_of("far/old.txt"), "new");
    EXPECT_EQ(fs::status(path("far/old.txt")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_TRUE(fs::is_symlink(path("first")) && fs::is_symlink(path("second")));
}

TEST_F(OutputFileTest, IsOnTheDiskBeforeItHasItsNameAndTheNameAfterIt) {
    const RecordedSyncs recorded;
    write("far/a.txt", "hello");
    EXPECT_EQ(recorded.calls, (Calls{"sync *", "rename * a.txt", "sync far"}));
}

TEST_F(OutputFileTest, ThroughALinkTheFolderOfTheTargetIsSynced) {
    link("far/new.txt", "alias");
    const RecordedSyncs recorded;
    write("alias", "hello");
    EXPECT_EQ(recorded.calls, (Calls{"sync *", "rename * new.txt", "sync far"}));
}

TEST_F(OutputFileTest, FinishSyncsSoThatAFullDiskIsFoundBeforeAnythingIsReplaced) {
    put("far/a.txt", "old");
    OutputFile file(path("far/a.txt").string());
    RecordedSyncs recorded;
    recorded.fsync_error = [](const fs::path&) { return ENOSPC; };
    EXPECT_EQ(error_of([&] { file.finish(); }).reason(), "cannot be written: No space left on device");
    EXPECT_EQ(recorded.calls, Calls{"sync *"});
    EXPECT_EQ(text_of("far/a.txt"), "old");
}

TEST_F(OutputFileTest, AFileThatDoesNotReachTheDiskIsNotRenamed) {
    put("far/a.txt", "old");
    RecordedSyncs recorded;
    recorded.fsync_error = [](const fs::path&) { return EIO; };
    const Error error = error_of([&] { write("far/a.txt", "new"); });
    EXPECT_EQ(error.code(), ErrorCode::failed);
    EXPECT_EQ(error.reason(), "cannot be written: Input/output error");
    EXPECT_EQ(error.file(), path("far/a.txt").string());
    EXPECT_EQ(text_of("far/a.txt"), "old");
    EXPECT_EQ(files_in("far"), 1u);
}

TEST_F(OutputFileTest, AFolderThatDoesNotReachTheDiskIsAnError) {
    RecordedSyncs recorded;
    recorded.fsync_error = [](const fs::path& p) { return fs::is_directory(p) ? std::optional(EIO) : std::nullopt; };
    const Error error = error_of([&] { write("far/a.txt", "new"); });
    EXPECT_EQ(error.code(), ErrorCode::failed);
    EXPECT_EQ(error.reason(), "the folder cannot be written to disk: Input/output error");
}

TEST_F(OutputFileTest, FileSystemsThatCannotSyncAreNoFault) {
    for (const int code : {EINVAL, ENOTSUP, ENOSYS}) {
        RecordedSyncs recorded;
        recorded.fsync_error = [code](const fs::path&) { return code; };
        EXPECT_NO_THROW(write("far/a.txt", std::to_string(code)));
        EXPECT_EQ(recorded.calls.size(), 3u);
        EXPECT_EQ(text_of("far/a.txt"), std::to_string(code));
    }
}

TEST_F(OutputFileTest, AnInterruptedSyncIsRepeated) {
    RecordedSyncs recorded;
    int interruptions = 2;
    recorded.fsync_error = [&](const fs::path&) { return interruptions-- > 0 ? EINTR : 0; };
    EXPECT_NO_THROW(write("far/a.txt", "x"));
    EXPECT_EQ(recorded.calls, (Calls{"sync *", "sync *", "sync *", "rename * a.txt", "sync far"}));
}

TEST_F(OutputFileTest, AFolderThatMayNotBeReadIsWrittenToAllTheSame) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may read anything";
    fs::permissions(path("far"), fs::perms::owner_write | fs::perms::owner_exec);
    EXPECT_NO_THROW(write("far/a.txt", "x"));
    fs::permissions(path("far"), fs::perms::owner_all);
    EXPECT_EQ(text_of("far/a.txt"), "x");
}

TEST_F(OutputFileTest, ADeviceIsNotSynced) {
    const RecordedSyncs recorded;
    OutputFile file("/dev/null");
    file.commit();
    EXPECT_EQ(recorded.calls, Calls{});
}

}  // namespace
}  // namespace rakelight::io
