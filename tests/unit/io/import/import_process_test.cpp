// SPDX-License-Identifier: Apache-2.0
// A helper that crashes, hangs, lies or is not there: each becomes one clear error. Small scripts play the helper.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>

#include "io/import/helper_process.h"
#include "io/import/stream_format.h"
#include "unit/io/import/import_support.h"

namespace rakelight::io::import_test {
namespace {

constexpr const char* triangle =
    "xof 0303txt 0032\nMesh m {\n 3;\n 0.0;0.0;0.0;,\n 1.0;0.0;0.0;,\n 0.0;1.0;0.0;;\n 1;\n 3;0,1,2;;\n}\n";

class ImportProcess : public ::testing::Test {
protected:
    void SetUp() override { model_ = folder_.write("model.x", triangle); }
    std::string script(const std::string& body) {
        const std::string path = folder_.write("helper.sh", "#!/bin/sh\n" + body + "\n");
        ::chmod(path.c_str(), 0755);
        return path;
    }
    Outcome read_by(const std::string& body, const ReadOptions& options = {}) {
        const EnvironmentVariable helper("RAKELIGHT_IMPORT", script(body));
        return read_import(model_, options);
    }
    rakelight::test::TemporaryFolder folder_;
    std::string model_;
};

TEST_F(ImportProcess, ACrashIsABadFileAndNamesTheSignal) {
    const Outcome outcome = read_by("kill -SEGV $$");
    ASSERT_TRUE(outcome.error);
    EXPECT_EQ(outcome.error->code(), ErrorCode::bad_file);
    EXPECT_NE(outcome.what().find("crashed (signal 11, SIGSEGV)"), std::string::npos) << outcome.what();
    EXPECT_NE(outcome.what().find("model.x"), std::string::npos);
}

TEST_F(ImportProcess, TheHelperOfTheContextGoesBeforeThatOfTheEnvironment) {
    const EnvironmentVariable helper("RAKELIGHT_IMPORT", "/bin/false");
    const std::string named = script("kill -SEGV $$");
    Context context({.import_helper = named});
    EXPECT_EQ(find_import_helper(context.import_helper()), named);
    try {
        import_reader.read(model_, {}, context);
        ADD_FAILURE() << "the model was read";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("SIGSEGV"), std::string::npos) << error.what();
    }
}

TEST_F(ImportProcess, AHelperThatIsNoProgramIsNamed) {
    Context context({.import_helper = model_});
    try {
        import_reader.read(model_, {}, context);
        ADD_FAILURE() << "the model was read";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::failed);
        EXPECT_NE(std::string(error.what()).find("is not a program"), std::string::npos) << error.what();
    }
}

TEST_F(ImportProcess, AHangEndsAtTheTimeLimit) {
    const auto begin = std::chrono::steady_clock::now();
    const Outcome outcome = read_by("exec sleep 60", {.import_seconds = 0.3});
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    ASSERT_TRUE(outcome.error);
    EXPECT_EQ(outcome.error->code(), ErrorCode::bad_file);
    EXPECT_NE(outcome.what().find("longer than 0.3 s"), std::string::npos) << outcome.what();
    EXPECT_LT(took.count(), 30);
}

TEST_F(ImportProcess, OutputThatTricklesDoesNotMoveTheDeadline) {
    const Outcome outcome = read_by("while :; do printf x; sleep 0.05; done", {.import_seconds = 0.4});
    ASSERT_TRUE(outcome.error);
    EXPECT_EQ(outcome.error->code(), ErrorCode::bad_file);
}

TEST_F(ImportProcess, ClosingTheStreamAndRunningOnEndsAtTheTimeLimit) {
    const auto begin = std::chrono::steady_clock::now();
    const Outcome outcome = read_by("exec sleep 60 >&-", {.import_seconds = 0.3});
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    ASSERT_TRUE(outcome.error);
    EXPECT_NE(outcome.what().find("longer than 0.3 s"), std::string::npos) << outcome.what();
    EXPECT_LT(took.count(), 30);
}

TEST_F(ImportProcess, EndingWithoutAWordIsABadFile) {
    const Outcome outcome = read_by("exit 7");
    ASSERT_TRUE(outcome.error);
    EXPECT_NE(outcome.what().find("exit code 7"), std::string::npos) << outcome.what();
}

TEST_F(ImportProcess, ForeignOutputIsABrokenStream) {
    const Outcome outcome = read_by("echo This is not the stream that was asked for");
    ASSERT_TRUE(outcome.error);
    EXPECT_EQ(outcome.error->code(), ErrorCode::bad_file);
    EXPECT_NE(outcome.what().find("broken stream"), std::string::npos) << outcome.what();
}

TEST_F(ImportProcess, AnotherVersionOfTheHelperIsNotTheFilesFault) {
    import_stream::Head head;
    head.stream_version = 999;
    std::string bytes(sizeof head, '\0');
    std::memcpy(bytes.data(), &head, sizeof head);
    std::ofstream(folder_ / "head", std::ios::binary) << bytes;
    const Outcome outcome = read_by("cat '" + (folder_ / "head").string() + "'");
    ASSERT_TRUE(outcome.error);
    EXPECT_EQ(outcome.error->code(), ErrorCode::failed);
    EXPECT_NE(outcome.what().find("999"), std::string::npos) << outcome.what();
}

TEST_F(ImportProcess, AMissingHelperIsSaidWithAdvice) {
    const EnvironmentVariable helper("RAKELIGHT_IMPORT", (folder_ / "nowhere").string());
    const Outcome outcome = read_import(model_);
    ASSERT_TRUE(outcome.error);
    EXPECT_EQ(outcome.error->code(), ErrorCode::failed);
    EXPECT_NE(outcome.what().find("RAKELIGHT_IMPORT"), std::string::npos) << outcome.what();
}

TEST_F(ImportProcess, TheHelperGetsNoStreamsOfTheProgram) {
    const Outcome outcome =
        read_by("cat >/dev/null; echo noise >&2; ls /proc/$$/fd > '" + (folder_ / "fds").string() + "'; exit 1");
    ASSERT_TRUE(outcome.error);
    std::ifstream in(folder_ / "fds");
    std::vector<int> open;
    for (int fd; in >> fd;) open.push_back(fd);
    EXPECT_GE(open.size(), 3u);
    for (int fd : open) EXPECT_TRUE(fd <= 2 || fd >= 10) << fd;  // shells keep their script at 10 or above
}

/// [fds] that are open here, below the limit.
int open_files(int limit) {
    int count = 0;
    for (int fd = 0; fd < limit; ++fd) count += ::fcntl(fd, F_GETFD) >= 0;
    return count;
}

/// With standard input closed and one more file free below the limit, a pipe can be made but not moved off the standard
/// streams. @return how many files more are open after the failure; negative: it did not fail
int files_left_open_by_a_failed_pipe() {
    constexpr int limit = 64;
    const rlimit files{limit, limit};
    ::setrlimit(RLIMIT_NOFILE, &files);
    int last = -1;
    for (int fd; (fd = ::open("/dev/null", O_RDONLY)) >= 0;) last = fd;
    ::close(STDIN_FILENO);
    ::close(last);
    const int before = open_files(limit);
    Context context({.threads = 1});
    try {
        HelperProcess("/bin/true", "model.x", {}, context);
    } catch (const Error&) {
        return open_files(limit) - before;
    }
    return -1;
}

TEST(ImportPipe, ThatFailsLeavesNoFileOpen) {  // without a folder, which the child would not remove
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the sanitizer makes a pipe to see whether memory can be read, and no file is free";
#endif
    testing::FLAGS_gtest_death_test_style = "threadsafe";  // files of this process stay as they are
    EXPECT_EXIT(std::_Exit(files_left_open_by_a_failed_pipe() & 0xff), testing::ExitedWithCode(0), "");
}

TEST_F(ImportProcess, ACancelledRunEndsTheHelper) {
    const EnvironmentVariable helper("RAKELIGHT_IMPORT", script("exec sleep 60"));
    Context context;
    context.cancel();
    EXPECT_THROW(import_reader.read(model_, {}, context), Error);
}

TEST_F(ImportProcess, AMissingOrEmptyFileNeedsNoHelper) {
    const EnvironmentVariable helper("RAKELIGHT_IMPORT", script("exit 0"));
    const Outcome missing = read_import((folder_ / "no.x").string());
    ASSERT_TRUE(missing.error);
    EXPECT_EQ(missing.error->code(), ErrorCode::not_found);
    std::ofstream(folder_ / "empty.x").flush();
    const Outcome empty = read_import((folder_ / "empty.x").string());
    ASSERT_TRUE(empty.error);
    EXPECT_EQ(empty.error->code(), ErrorCode::bad_file);
    const Outcome unknown = read_import((folder_ / "helper.sh").string());
    ASSERT_TRUE(unknown.error);
    EXPECT_EQ(unknown.error->code(), ErrorCode::bad_file);
}

}  // namespace
}  // namespace rakelight::io::import_test
