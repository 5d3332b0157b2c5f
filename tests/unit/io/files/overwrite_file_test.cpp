// SPDX-License-Identifier: Apache-2.0
// Files that are overwritten where they are.
#include "io/files/output_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

#include "support/temporary_folder.h"
#include "unit/io/pictures/image_io_support.h"

namespace rakelight::io {
namespace {

using test::bytes_of_file;
using test::error_of;

int close_error = 0;  ///< what close() says after it closed; 0: the truth

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

class OverwriteFile : public testing::Test {
protected:
    void SetUp() override { std::ofstream(path()) << "older and longer"; }
    void TearDown() override { close_error = 0; }
    std::string path() const { return (folder_ / "file").string(); }

private:
    test::TemporaryFolder folder_;
};

TEST_F(OverwriteFile, ReplacesAllOfIt) {
    overwrite_file(path(), bytes_of("new"));
    const auto bytes = bytes_of_file(path());
    EXPECT_TRUE(std::ranges::equal(bytes, bytes_of("new")));
}

TEST_F(OverwriteFile, WhatCloseSaysIsAnErrorAndLeavesItEmpty) {
    close_error = EDQUOT;
    const Error error = error_of([&] { overwrite_file(path(), bytes_of("new")); });
    close_error = 0;
    EXPECT_EQ(error.code(), ErrorCode::failed);
    EXPECT_NE(std::string(error.what()).find("quota"), std::string::npos) << error.what();
    EXPECT_EQ(std::filesystem::file_size(path()), 0u);
}

TEST_F(OverwriteFile, AFifoThatNobodyReadsIsAnError) {
    std::filesystem::remove(path());
    ASSERT_EQ(::mkfifo(path().c_str(), 0600), 0);
    const Error error = error_of([&] { overwrite_file(path(), bytes_of("new")); });
    EXPECT_NE(std::string(error.what()).find("nobody reads from it"), std::string::npos) << error.what();
}

}  // namespace
}  // namespace rakelight::io

/// The linker prefers it to libc's.
extern "C" int close(int fd) {
    const long result = ::syscall(SYS_close, fd);
    if (result == 0 && rakelight::io::close_error != 0) return errno = rakelight::io::close_error, -1;
    return int(result);
}
