// SPDX-License-Identifier: Apache-2.0
#include "io/import/helper_process.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "base/format_text.h"
#include "io/file.h"

namespace rakelight::io {
namespace {

constexpr const char* helper_name = "rakelight-import";

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return path.substr(0, slash == std::string::npos ? 0 : slash);
}

std::string folder_of_this_program() {
    char path[PATH_MAX];
    const ssize_t size = readlink("/proc/self/exe", path, sizeof path);
    return folder_of(std::string(path, size > 0 ? std::size_t(size) : 0));
}

/// Of the shared library that holds this code, or of the program.
std::string folder_of_this_library() {
    Dl_info info{};
    const bool is_known = dladdr(reinterpret_cast<const void*>(&folder_of_this_program), &info) != 0 && info.dli_fname;
    return folder_of(is_known ? info.dli_fname : "");
}

bool is_program(const std::string& path) { return is_regular_file(path) && access(path.c_str(), X_OK) == 0; }

/// The environment variables of the helper: the C locale for numbers, and what loading it may need.
std::vector<std::string> helper_environment() {
    std::vector<std::string> variables{"LC_ALL=C", "MALLOC_ARENA_MAX=1"};
    for (const char* name : {"LD_LIBRARY_PATH", "ASAN_OPTIONS", "UBSAN_OPTIONS"})
        if (const char* value = std::getenv(name)) variables.push_back(std::string(name) + "=" + value);
    return variables;
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
    std::vector<char*> result;
    for (std::string& s : strings) result.push_back(s.data());
    result.push_back(nullptr);
    return result;
}

struct FileActions {
    posix_spawn_file_actions_t actions;
    FileActions() { posix_spawn_file_actions_init(&actions); }
    ~FileActions() { posix_spawn_file_actions_destroy(&actions); }
};

struct Attributes {
    posix_spawnattr_t attributes;
    Attributes() { posix_spawnattr_init(&attributes); }
    ~Attributes() { posix_spawnattr_destroy(&attributes); }
};

/// Default handlers and an empty mask: the caller may ignore SIGPIPE or block signals, the helper must not inherit that.
void reset_signals(Attributes& a) {
    sigset_t every, no;
    sigfillset(&every);
    sigemptyset(&no);
    posix_spawnattr_setsigdefault(&a.attributes, &every);
    posix_spawnattr_setsigmask(&a.attributes, &no);
    posix_spawnattr_setflags(&a.attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
}

std::string seconds_text(double seconds) {
    const double tenths = std::round(seconds * 10);
    const auto whole = static_cast<long long>(tenths / 10), tenth = static_cast<long long>(tenths) % 10;
    return format_text("{}{} s", whole, tenth != 0 ? "." + std::to_string(tenth) : "");
}

const char* name_of_signal(int number) {
    switch (number) {
        case SIGSEGV:
            return ", SIGSEGV";
        case SIGABRT:
            return ", SIGABRT";
        case SIGBUS:
            return ", SIGBUS";
        case SIGFPE:
            return ", SIGFPE";
        case SIGILL:
            return ", SIGILL";
        case SIGKILL:
            return ", SIGKILL";
        default:
            return "";
    }
}

[[noreturn]] void too_slow(double seconds) {
    throw Error(ErrorCode::bad_file, "reading it took longer than " + seconds_text(seconds) + " and was stopped", {},
                "export glTF instead");
}

}  // namespace

std::string find_import_helper(const std::string& asked) {
    if (!asked.empty()) {
        if (is_program(asked)) return asked;
        throw Error(ErrorCode::failed, "the import helper '" + one_line(asked, 100) + "' is not a program");
    }
    if (const char* named = std::getenv("RAKELIGHT_IMPORT")) {
        if (is_program(named)) return named;
        throw Error(ErrorCode::failed, std::string("RAKELIGHT_IMPORT names '") + named + "', which is not a program",
                    {}, "correct or unset it");
    }
    const std::string program = folder_of_this_program(), library = folder_of_this_library();
    // RL_LIBEXEC_*: where it is installed, counted from programs, from the library, and from the root (CMakeLists.txt of io).
    for (const std::string& folder : {program, program + "/" RL_LIBEXEC_FROM_BIN, library,
                                      library + "/" RL_LIBEXEC_FROM_LIB, std::string(RL_LIBEXEC)})
        if (const std::string candidate = folder + "/" + helper_name; is_program(candidate)) return candidate;
    throw Error(ErrorCode::failed, "this format needs the program rakelight-import, which is not there", {},
                "put it beside the program, set RAKELIGHT_IMPORT, or export glTF");
}

namespace {

/// The two ends of a pipe, neither of them a standard stream (which may be closed here, and is set again in the child).
/// Both are closed where it fails.
void open_pipe(int (&ends)[2]) {
    const auto failed = [] {
        return Error(ErrorCode::failed, std::string("no pipe for the import helper: ") + std::strerror(errno));
    };
    if (pipe2(ends, O_CLOEXEC) != 0) throw failed();
    for (int& end : ends) {
        if (end > 2) continue;
        const int moved = fcntl(end, F_DUPFD_CLOEXEC, 3);
        if (moved < 0) {
            const Error error = failed();  // before close() changes errno
            for (const int open : ends) close(open);
            throw error;
        }
        close(end);
        end = moved;
    }
}

}  // namespace

HelperProcess::HelperProcess(const std::string& helper, const std::string& model, const HelperLimits& limits,
                             Context& context)
    : context_(context), limits_(limits) {
    int ends[2];
    open_pipe(ends);
    pipe_ = ends[0];
    FileActions files;
    posix_spawn_file_actions_addopen(&files.actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files.actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&files.actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&files.actions, 3);
    Attributes attributes;
    reset_signals(attributes);
    const auto cpu_seconds = static_cast<long long>(std::ceil(std::min(limits.seconds, 1e6))) + 1;
    std::vector<std::string> words{helper,
                                   "--memory",
                                   std::to_string(limits.memory_bytes),
                                   "--seconds",
                                   std::to_string(cpu_seconds),
                                   "--outside",
                                   limits.allow_outside ? "1" : "0",
                                   "--",
                                   model};
    std::vector<std::string> variables = helper_environment();
    deadline_ = std::chrono::steady_clock::now() +
                std::chrono::milliseconds(static_cast<long long>(std::min(limits.seconds, 1e6) * 1000));
    const int failure = posix_spawn(&child_, helper.c_str(), &files.actions, &attributes.attributes,
                                    pointers(words).data(), pointers(variables).data());
    close(ends[1]);
    if (failure == 0) return;
    child_ = -1;
    close(pipe_);
    throw Error(ErrorCode::failed, "the import helper " + helper + " does not start: " + std::strerror(failure));
}

HelperProcess::~HelperProcess() {
    kill_and_reap();
    close(pipe_);
}

void HelperProcess::kill_and_reap() noexcept {
    if (child_ < 0) return;
    kill(child_, SIGKILL);
    while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
}

void HelperProcess::wait_for_bytes() {
    using namespace std::chrono;
    for (;;) {
        context_.throw_if_cancelled();
        const auto left = duration_cast<milliseconds>(deadline_ - steady_clock::now()).count();
        if (left <= 0) too_slow(limits_.seconds);
        pollfd wait{pipe_, POLLIN, 0};
        const int ready = poll(&wait, 1, int(std::min<long long>(left, 100)));
        if (ready > 0) return;
        if (ready < 0 && errno != EINTR)
            throw Error(ErrorCode::failed,
                        std::string("waiting for the import helper failed: ") + std::strerror(errno));
    }
}

void HelperProcess::read(std::span<std::byte> to) {
    while (!to.empty()) {
        wait_for_bytes();
        const ssize_t got = ::read(pipe_, to.data(), to.size());
        if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (got < 0)
            throw Error(ErrorCode::failed,
                        std::string("reading from the import helper failed: ") + std::strerror(errno));
        if (got == 0) ended_early();
        to = to.subspan(std::size_t(got));
    }
}

void HelperProcess::ended_early() {
    // Most often it is ending; but one that only closed its end may run on, and still has no longer than the others.
    int status = 0;
    for (;;) {
        const pid_t ended = waitpid(child_, &status, WNOHANG);
        if (ended > 0 || (ended < 0 && errno != EINTR)) break;
        context_.throw_if_cancelled();
        if (std::chrono::steady_clock::now() >= deadline_) too_slow(limits_.seconds);
        poll(nullptr, 0, 1);
    }
    child_ = -1;
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) too_slow(limits_.seconds);
    if (WIFSIGNALED(status)) {
        const int number = WTERMSIG(status);
        throw Error(ErrorCode::bad_file,
                    format_text("the import helper crashed (signal {}{}) on this file", number, name_of_signal(number)),
                    {}, "the file may be broken; export glTF instead");
    }
    throw Error(ErrorCode::bad_file, format_text("the import helper ended early (exit code {})",
                                                 WIFEXITED(status) ? WEXITSTATUS(status) : -1));
}

}  // namespace rakelight::io
