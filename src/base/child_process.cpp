// SPDX-License-Identifier: Apache-2.0
#include "base/child_process.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <rakelight/base/context.h>

#include "base/format_text.h"

namespace rakelight {
namespace {

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

bool is_program(const std::string& path) {
    struct ::stat status {};
    return ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && access(path.c_str(), X_OK) == 0;
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

/// The two ends of a pipe, neither of them a standard stream (which may be closed here, and is set again in the child).
/// Both are closed where it fails.
void open_pipe(const std::string& name, int (&ends)[2]) {
    const auto failed = [&name] {
        return Error(ErrorCode::failed, "no pipe for the " + name + ": " + std::strerror(errno));
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

std::string find_helper(const HelperProgram& program, const std::string& asked) {
    if (!asked.empty()) {
        if (is_program(asked)) return asked;
        throw Error(ErrorCode::failed,
                    std::string("the ") + program.name + " '" + one_line(asked, 100) + "' is not a program");
    }
    if (const char* named = std::getenv(program.variable)) {
        if (is_program(named)) return named;
        throw Error(ErrorCode::failed, std::string(program.variable) + " names '" + named + "', which is not a program",
                    {}, "correct or unset it");
    }
    const std::string own = folder_of_this_program(), library = folder_of_this_library();
    // RL_LIBEXEC_*: where it is installed, counted from programs, from the library, and from the root (CMakeLists.txt).
    for (const std::string& folder :
         {own, own + "/" RL_LIBEXEC_FROM_BIN, library, library + "/" RL_LIBEXEC_FROM_LIB, std::string(RL_LIBEXEC)})
        if (const std::string candidate = folder + "/" + program.file; is_program(candidate)) return candidate;
    throw Error(ErrorCode::failed, program.missing, {}, program.advice);
}

ChildProcess::ChildProcess(const std::string& name, ChildStart start) : name_(name) {
    int ends[2];
    open_pipe(name, ends);
    pipe_ = ends[0];
    FileActions files;
    if (start.input >= 0)
        posix_spawn_file_actions_adddup2(&files.actions, start.input, STDIN_FILENO);
    else
        posix_spawn_file_actions_addopen(&files.actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files.actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&files.actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&files.actions, 3);
    Attributes attributes;
    reset_signals(attributes);
    deadline_ = std::chrono::steady_clock::now() +
                std::chrono::milliseconds(static_cast<long long>(std::min(start.seconds, 1e6) * 1000));
    const int failure = posix_spawn(&child_, start.words[0].c_str(), &files.actions, &attributes.attributes,
                                    pointers(start.words).data(), pointers(start.variables).data());
    close(ends[1]);
    if (failure == 0) return;
    child_ = -1;
    close(pipe_);
    throw Error(ErrorCode::failed, "the " + name + " " + start.words[0] + " does not start: " + std::strerror(failure));
}

ChildProcess::~ChildProcess() {
    kill_and_reap();
    close(pipe_);
}

void ChildProcess::kill_and_reap() noexcept {
    if (child_ < 0) return;
    kill(child_, SIGKILL);
    while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
}

std::optional<std::size_t> ChildProcess::read(std::span<std::byte> to, Context* context) {
    using namespace std::chrono;
    for (;;) {
        if (context) context->throw_if_cancelled();
        const auto left = duration_cast<milliseconds>(deadline_ - steady_clock::now()).count();
        if (left <= 0) return {};
        pollfd wait{pipe_, POLLIN, 0};
        const int ready = poll(&wait, 1, int(std::min<long long>(left, 100)));
        if (ready < 0 && errno != EINTR)
            throw Error(ErrorCode::failed, "waiting for the " + name_ + " failed: " + std::strerror(errno));
        if (ready <= 0) continue;
        const ssize_t got = ::read(pipe_, to.data(), to.size());
        if (got >= 0) return std::size_t(got);
        if (errno != EINTR && errno != EAGAIN)
            throw Error(ErrorCode::failed, "reading from the " + name_ + " failed: " + std::strerror(errno));
    }
}

/// Most often it is ending; but one that only closed its end may run on, and still has no longer than the others.
std::optional<int> ChildProcess::wait(Context* context) {
    int status = 0;
    for (;;) {
        const pid_t ended = waitpid(child_, &status, WNOHANG);
        if (ended > 0 || (ended < 0 && errno != EINTR)) break;
        if (context) context->throw_if_cancelled();
        if (std::chrono::steady_clock::now() >= deadline_) return {};
        poll(nullptr, 0, 1);
    }
    child_ = -1;
    return status;
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

std::string seconds_text(double seconds) {
    const double tenths = std::round(seconds * 10);
    const auto whole = static_cast<long long>(tenths / 10), tenth = static_cast<long long>(tenths) % 10;
    return format_text("{}{} s", whole, tenth != 0 ? "." + std::to_string(tenth) : "");
}

}  // namespace rakelight
