// SPDX-License-Identifier: Apache-2.0
#include "io/files/file.h"
#include "io/files/output_file.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/temporary_folder.h"
#include "support/thrown_error.h"

namespace rakelight::io {
namespace {

namespace fs = std::filesystem;
using test::error_of;

class FileTest : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directories(folder_ / "model" / "textures");
        fs::create_directories(folder_ / "other");
    }
    void TearDown() override { fs::permissions(folder_ / "other", fs::perms::owner_all); }
    std::string put(const std::string& name, const std::string& text) const { return folder_.write(name, text); }
    std::string text_of(const std::string& name) const {
        std::ostringstream text;
        text << std::ifstream(folder_ / name, std::ios::binary).rdbuf();
        return text.str();
    }
    std::size_t files_in(const std::string& name) const {
        return std::size_t(std::distance(fs::directory_iterator(folder_ / name), fs::directory_iterator()));
    }
    std::string model() const { return (folder_ / "model" / "m.gltf").string(); }
    test::TemporaryFolder folder_;
    Context context_;
};

std::string as_text(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::span<const std::byte> as_bytes(const std::string& text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

TEST_F(FileTest, ReadsARegularFileWholeAndThroughALink) {
    const std::string path = put("model/a.bin", std::string("ab\0cd", 5));
    fs::create_symlink(path, folder_ / "link");
    EXPECT_EQ(as_text(*read_file(path, context_)), std::string("ab\0cd", 5));
    EXPECT_EQ(as_text(*read_file((folder_ / "link").string(), context_)), std::string("ab\0cd", 5));
    EXPECT_TRUE(is_regular_file(path));
}

TEST_F(FileTest, ReadsAnEmptyFileAsNoBytes) { EXPECT_TRUE(read_file(put("empty", ""), context_)->empty()); }

TEST_F(FileTest, RefusesWhatIsNoRegularFileWithoutWaitingForIt) {
    const std::string fifo = (folder_ / "fifo").string(), socket_path = (folder_ / "s").string();
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    const int fd = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    ASSERT_LT(socket_path.size(), sizeof(address.sun_path));
    std::strcpy(address.sun_path, socket_path.c_str());
    ASSERT_EQ(::bind(fd, reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
    for (const std::string& path :
         {fifo, socket_path, folder_.path().string(), std::string("/dev/zero"), (folder_ / "absent").string(),
          std::string(), std::string("a\0b", 3), std::string(5000, 'x')}) {
        const Error error = error_of([&] { read_file(path, context_); });
        EXPECT_EQ(error.code(), ErrorCode::not_found) << error.what();
        EXPECT_FALSE(is_regular_file(path));
    }
    ::close(fd);
}

TEST_F(FileTest, AnErrorOfReadingNamesTheFile) {
    const std::string path = (folder_ / "absent").string();
    EXPECT_EQ(error_of([&] { read_file(path, context_); }).file(), path);
}

TEST_F(FileTest, HoldsTheSizeAgainstTheMemoryLimit) {
    const std::string path = put("large", std::string(1000, 'x'));
    Context small({.max_memory = 999});
    EXPECT_EQ(error_of([&] { read_file(path, small); }).code(), ErrorCode::bad_file);
    Context enough({.max_memory = 1000});
    EXPECT_EQ(read_file(path, enough)->size(), 1000u);
}

TEST_F(FileTest, TellsTheBudgetHowMuchWasRead) {
    const std::string path = (folder_ / "sparse").string();
    put("sparse", "");
    fs::resize_file(path, 40u << 20);
    const std::uint64_t before = context_.memory().limit();
    const Bytes bytes = read_file(path, context_);
    EXPECT_EQ(context_.memory().limit(), std::uint64_t(40u << 20) * 64);
    EXPECT_GT(context_.memory().limit(), before);
}

TEST_F(FileTest, ResolvesReferencesBesideTheModel) {
    const fs::path base = folder_ / "model";
    EXPECT_EQ(resolve_reference(model(), "a.bin", false), (base / "a.bin").string());
    EXPECT_EQ(resolve_reference(model(), "textures\\a.png", false), (base / "textures/a.png").string());
    EXPECT_EQ(resolve_reference(model(), "textures/../a.png", false), (base / "textures/../a.png").string());
    EXPECT_EQ(resolve_reference(model(), "./a:b.png", false), (base / "./a:b.png").string());
    EXPECT_EQ(resolve_reference("m.gltf", "a.bin", false), "a.bin");
}

TEST_F(FileTest, RefusesReferencesThatLeaveTheFolder) {
    put("other/secret", "x");
    fs::create_directory_symlink(folder_ / "other", folder_ / "model" / "out");
    fs::create_symlink(folder_ / "other" / "secret", folder_ / "model" / "leak.png");
    fs::create_symlink("loop", folder_ / "model" / "loop");
    for (const char* reference : {"",
                                  "../other/secret",
                                  "..\\other\\secret",
                                  "textures/../../other/secret",
                                  "absent/../../other/secret",
                                  "..",
                                  "/etc/passwd",
                                  "\\\\server\\share\\x",
                                  "C:\\x.png",
                                  "c:x.png",
                                  "http://example.org/x.png",
                                  "HTTPS:x.png",
                                  "file:///etc/passwd",
                                  "file:x.png",
                                  "data:,x",
                                  "gopher://x/y",
                                  "out/secret",
                                  "out/absent",
                                  "leak.png",
                                  "loop/x",
                                  "../model2/x",
                                  "../modelx"}) {
        const Error error = error_of([&] { resolve_reference(model(), reference, false); });
        EXPECT_EQ(error.code(), ErrorCode::bad_file) << reference;
    }
    EXPECT_THROW(resolve_reference(model(), std::string("a\0b", 3), false), Error);
    EXPECT_THROW(resolve_reference(model(), std::string("a\0b", 3), true), Error);
    EXPECT_THROW(resolve_reference(model(), "a/" + std::string(70000, '/') + "../../../x", false), Error);
}

TEST_F(FileTest, ARefusalNamesTheReferenceAsItIsWrittenAndWhatHelps) {
    const Error error = error_of([&] { resolve_reference(model(), "..\\..\\folder/name.png", false); });
    EXPECT_NE(error.reason().find("'..\\..\\folder/name.png'"), std::string::npos) << error.what();
    EXPECT_EQ(error.related(), std::vector<std::string>{"allow-outside"});
}

TEST_F(FileTest, APathOfAnotherMachineIsRefusedWithWhatToDoWhereverReferencesMayLead) {
    for (const bool allow_outside : {false, true}) {
        const Error error = error_of([&] { resolve_reference(model(), "C:\\work\\wood.png", allow_outside); });
        EXPECT_NE(error.reason().find("'C:\\work\\wood.png' is a path on another machine"), std::string::npos);
        EXPECT_NE(error.advice().find("'wood.png'"), std::string::npos) << error.what();
        EXPECT_TRUE(error.related().empty());
    }
}

TEST_F(FileTest, WhatIsNotFoundIsOutsideOrNowhere) {
    put("other.png", "x");
    EXPECT_NE(why_not_found(model(), "../other.png", "gone").find("'allow-outside'"), std::string::npos);
    EXPECT_EQ(why_not_found(model(), "../nothing.png", "gone"), " is not in the model's folder; gone");
    EXPECT_EQ(why_not_found(model(), "", "gone"), " is not in the model's folder; gone");
}

TEST_F(FileTest, FollowsReferencesAnywhereWhenAllowed) {
    EXPECT_EQ(resolve_reference(model(), "../other/x", true), (folder_ / "model/../other/x").string());
    EXPECT_EQ(resolve_reference(model(), "/abs/x", true), "/abs/x");
}

TEST_F(FileTest, AllowsALinkInsideTheFolderAndALinkedModelFolder) {
    put("model/textures/a.png", "x");
    fs::create_symlink("textures/a.png", folder_ / "model" / "alias.png");
    EXPECT_NO_THROW(resolve_reference(model(), "alias.png", false));
    fs::create_directory_symlink(folder_ / "model", folder_ / "linked");
    EXPECT_NO_THROW(resolve_reference((folder_ / "linked" / "m.gltf").string(), "textures/a.png", false));
}

TEST(PercentDecode, UndoesEscapesAndRefusesBrokenOnes) {
    EXPECT_EQ(percent_decode("a%20b%2Fc%c3%A4"), "a b/c\xc3\xa4");
    EXPECT_EQ(percent_decode(""), "");
    EXPECT_EQ(percent_decode("%00"), std::string(1, '\0'));
    for (const char* broken : {"%", "a%", "a%2", "%g0", "%0g", "%%20"}) EXPECT_FALSE(percent_decode(broken)) << broken;
}

TEST(Base64Decode, ReadsTheVectorsOfRfc4648WithAndWithoutPadding) {
    const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                           {"Zg==", "f"},
                                                           {"Zm8=", "fo"},
                                                           {"Zm9v", "foo"},
                                                           {"Zm9vYg==", "foob"},
                                                           {"Zm9vYmE=", "fooba"},
                                                           {"Zm9vYmFy", "foobar"},
                                                           {"Zg", "f"},
                                                           {"Zm8", "fo"},
                                                           {"+/+/", "\xfb\xff\xbf"}};
    for (const auto& [encoded, plain] : vectors) {
        const auto bytes = base64_decode(encoded);
        ASSERT_TRUE(bytes) << encoded;
        EXPECT_EQ(as_text(*bytes), plain);
    }
}

TEST(Base64Decode, RefusesIllegalText) {
    for (const char* broken :
         {"A", "AAAAA", "Zg=", "Z===", "====", "=", "Zm9v\n", "Zm 9", "Zg==Zg==", "-_-_", "Zm9\xff"})
        EXPECT_FALSE(base64_decode(broken)) << broken;
}

TEST_F(FileTest, OutputAppearsOnlyWhenCommitted) {
    const std::string path = (folder_ / "other" / "out.txt").string();
    {
        OutputFile file(path);
        file.write(as_bytes("hello"));
        EXPECT_FALSE(fs::exists(path));
        EXPECT_EQ(files_in("other"), 1u);
        file.commit();
    }
    EXPECT_EQ(text_of("other/out.txt"), "hello");
    EXPECT_EQ(files_in("other"), 1u);
    {
        OutputFile file(path);
        file.write(as_bytes("lost"));
    }
    EXPECT_EQ(text_of("other/out.txt"), "hello");
    EXPECT_EQ(files_in("other"), 1u);
}

TEST_F(FileTest, TwoOutputsToOnePathDoNotDisturbEachOther) {
    const std::string path = (folder_ / "other" / "out.txt").string();
    OutputFile first(path), second(path);
    first.write(as_bytes("first"));
    second.write(as_bytes("second"));
    second.commit();
    first.commit();
    EXPECT_EQ(text_of("other/out.txt"), "first");
}

TEST_F(FileTest, WritesThroughALinkAndKeepsThePermissions) {
    const std::string path = put("other/real", "old");
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink(path, folder_ / "alias");
    OutputFile file((folder_ / "alias").string());
    file.write(as_bytes("new"));
    file.commit();
    EXPECT_TRUE(fs::is_symlink(folder_ / "alias"));
    EXPECT_EQ(text_of("other/real"), "new");
    EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(FileTest, ADeviceIsWrittenToAndNotReplaced) {
    OutputFile file("/dev/null");
    file.write(as_bytes("x"));
    file.commit();
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(FileTest, RefusesOutputThatCannotBeMade) {
    for (const std::string& path :
         {folder_.path().string(), std::string(), std::string("a\0b", 3), put("plain", "x") + "/below"}) {
        EXPECT_EQ(error_of([&] { OutputFile file(path); }).code(), ErrorCode::failed);
    }
}

TEST_F(FileTest, MissingFoldersAreMadeAndGoAgainWhenNothingIsWritten) {
    const fs::path path = folder_ / "a" / "b" / "c.txt";
    { OutputFile file(path.string()); }
    EXPECT_FALSE(fs::exists(folder_ / "a"));
    {
        OutputFile first(path.string());
        OutputFile second((folder_ / "a" / "d.txt").string());
        second.commit();
    }
    EXPECT_TRUE(fs::exists(folder_ / "a" / "d.txt"));  // what holds something stays
    EXPECT_FALSE(fs::exists(folder_ / "a" / "b"));
    OutputFile file(path.string());
    file.commit();
    EXPECT_TRUE(fs::is_regular_file(path));
}

TEST_F(FileTest, AReadOnlyFolderIsAnErrorOfOutput) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
    fs::permissions(folder_ / "other", fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_EQ(error_of([&] { OutputFile file((folder_ / "other" / "x").string()); }).code(), ErrorCode::failed);
}

TEST_F(FileTest, AFullDiskIsAnError) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    OutputFile file("/dev/full");
    const Error error = error_of([&] {
        file.write(as_bytes(std::string(1 << 20, 'x')));
        file.commit();
    });
    EXPECT_EQ(error.code(), ErrorCode::failed);
}

}  // namespace
}  // namespace rakelight::io
