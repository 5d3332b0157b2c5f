// SPDX-License-Identifier: Apache-2.0
#include "io/movie/ffmpeg_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string>
#include <utility>

#include "io/files/descriptor.h"
#include "io/files/file.h"

namespace rakelight::io {
namespace {

constexpr int pause_ms = 50;       ///< between two looks whether the context was cancelled
constexpr int first_free_fd = 10;  ///< above those that the child gets
constexpr std::size_t most_words = 400;

[[noreturn]] void failed(const std::string& what, int code) {
    throw Error(ErrorCode::failed, what + ": " + system_message(code));
}

/// A copy of a descriptor above all numbers that the child's descriptors have: none of them is overwritten on the way.
int moved_up(int fd) {
    const int moved = ::fcntl(fd, F_DUPFD_CLOEXEC, first_free_fd);
    if (moved < 0) failed("no descriptor for ffmpeg", errno);
    return moved;
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
    std::vector<char*> result;
    for (std::string& s : strings) result.push_back(s.data());
    result.push_back(nullptr);
    return result;
}

/// The C locale: plain numbers and English messages.
std::vector<std::string> environment() {
    std::vector<std::string> variables{"LC_ALL=C"};
    for (const char* name : {"PATH", "LD_LIBRARY_PATH", "HOME"})
        if (const char* value = std::getenv(name)) variables.push_back(std::string(name) + "=" + value);
    return variables;
}

Error not_installed() {
    return Error(ErrorCode::failed, "MP4, WebM and GIF are written by the program ffmpeg, which is not there", {},
                 "install the package ffmpeg, or write .apng or .webp");
}

/// The child; one that still runs is killed at the end.
class Child {
public:
    Child(const FfmpegRun& run, int input, int words) {
        posix_spawn_file_actions_t files;
        posix_spawnattr_t attributes;
        posix_spawn_file_actions_init(&files);
        posix_spawnattr_init(&attributes);
        const Descriptor in{moved_up(input)}, messages{moved_up(words)}, output{moved_up(run.output)},
            second{run.second_input < 0 ? -1 : moved_up(run.second_input)};
        posix_spawn_file_actions_adddup2(&files, in.fd, STDIN_FILENO);
        posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&files, messages.fd, STDERR_FILENO);
        posix_spawn_file_actions_adddup2(&files, output.fd, 3);
        if (second.fd >= 0) posix_spawn_file_actions_adddup2(&files, second.fd, 4);
        posix_spawn_file_actions_addclosefrom_np(&files, second.fd >= 0 ? 5 : 4);
        sigset_t every, none;
        sigfillset(&every), sigemptyset(&none);
        posix_spawnattr_setsigdefault(&attributes, &every);
        posix_spawnattr_setsigmask(&attributes, &none);
        posix_spawnattr_setpgroup(&attributes, 0);  // Ctrl-C is this program's: it ends the child then
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
        std::vector<std::string> arguments{"ffmpeg"}, variables = environment();
        arguments.insert(arguments.end(), run.arguments.begin(), run.arguments.end());
        const int code = ::posix_spawnp(&pid_, "ffmpeg", &files, &attributes, pointers(arguments).data(),
                                        pointers(variables).data());
        posix_spawn_file_actions_destroy(&files);
        posix_spawnattr_destroy(&attributes);
        if (code == 0) return;
        pid_ = -1;
        if (code == ENOENT) throw not_installed();
        failed("ffmpeg does not start", code);
    }
    ~Child() {
        if (pid_ < 0) return;
        ::kill(pid_, SIGKILL);
        while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// @return whether it ended well
    bool wait(Context& context) {
        int status = 0;
        for (;;) {
            const pid_t ended = ::waitpid(pid_, &status, WNOHANG);
            if (ended == pid_) break;
            if (ended < 0 && errno != EINTR) failed("ffmpeg cannot be waited for", errno);
            context.throw_if_cancelled();
            ::poll(nullptr, 0, pause_ms);
        }
        pid_ = -1;
        return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }

private:
    pid_t pid_ = -1;
};

/// @return false: the reader has closed its end
bool send_all(int to, std::span<const std::byte> bytes, Context& context) {
    while (!bytes.empty()) {
        context.throw_if_cancelled();
        const ssize_t sent = ::send(to, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent >= 0) {
            bytes = bytes.subspan(std::size_t(sent));
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            pollfd wait{to, POLLOUT, 0};
            ::poll(&wait, 1, pause_ms);
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

void feed(int to, const FfmpegRun& run, Context& context) {
    const double count = double(run.pictures.size());
    for (std::size_t i = 0; i < run.pictures.size(); ++i) {
        const double done = double(i) / count;
        context.progress("movie", run.progress_from + (run.progress_to - run.progress_from) * done);
        if (!send_all(to, *read_file(run.pictures[i], context, i > 0), context)) return;
    }
}

/// The messages that ffmpeg wrote, on one line.
std::string last_messages(int words) {
    std::array<char, most_words> text{};
    const ssize_t size = ::pread(words, text.data(), text.size(), 0);
    std::string all(text.data(), size > 0 ? std::size_t(size) : 0);
    while (!all.empty() && (all.back() == '\n' || all.back() == ' ')) all.pop_back();
    for (char& c : all) c = c == '\n' ? ' ' : c;
    return all.empty() ? "" : ": " + one_line(all, most_words);
}

}  // namespace

void check_ffmpeg() {
    const char* const path = std::getenv("PATH");
    std::string folders = path ? path : "/bin:/usr/bin";
    for (std::size_t at = 0; at <= folders.size();) {
        const std::size_t end = std::min(folders.find(':', at), folders.size());
        const std::string folder = folders.substr(at, end - at);
        if (::access(((folder.empty() ? "." : folder) + "/ffmpeg").c_str(), X_OK) == 0) return;
        at = end + 1;
    }
    throw not_installed();
}

void run_ffmpeg(const FfmpegRun& run, Context& context) {
    const Descriptor words{::memfd_create("ffmpeg's words", MFD_CLOEXEC)};
    if (words.fd < 0) failed("no memory for the output of ffmpeg", errno);
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) failed("no pipe for ffmpeg", errno);
    Descriptor ours{ends[0]}, theirs{ends[1]};
    Child child(run, theirs.fd, words.fd);
    ::close(std::exchange(theirs.fd, -1));  // the child has the only other end, so its end is noticed
    feed(ours.fd, run, context);
    ::close(std::exchange(ours.fd, -1));
    if (!child.wait(context)) throw Error(ErrorCode::failed, "ffmpeg failed" + last_messages(words.fd));
}

}  // namespace rakelight::io
