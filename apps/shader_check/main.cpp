// SPDX-License-Identifier: Apache-2.0
// The program `rakelight-shader-check`: takes one OpenGL program from standard input through the driver, within limits on memory and
// time, and says what the driver says. Started by rakelight only (src/engines/opengl/programs/shader_check.h).
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>

#include "../common/helper_limits.h"
#include "engines/opengl/programs/trial.h"

namespace rakelight::shader_check {
namespace {

constexpr std::size_t most_bytes = 64 << 20;  ///< of both texts

struct Limits {
    std::uint64_t memory_bytes = 0, seconds = 0;
};

bool parse(int argc, char** argv, Limits& limits) {
    if (argc != 5 || std::strcmp(argv[1], "--memory") != 0 || std::strcmp(argv[3], "--seconds") != 0) return false;
    limits = {std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[4], nullptr, 10)};
    return limits.memory_bytes > 0 && limits.seconds > 0;
}

std::string all_input() {
    std::string all;
    char bytes[65536];
    for (;;) {
        const ssize_t got = read(STDIN_FILENO, bytes, sizeof bytes);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0 || all.size() > most_bytes) return all;
        all.append(bytes, std::size_t(got));
    }
}

std::uint64_t address_space() {
    std::ifstream file("/proc/self/statm");
    std::uint64_t pages = 0;
    file >> pages;
    return pages * std::uint64_t(sysconf(_SC_PAGESIZE));
}

std::uint64_t used_seconds() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return std::uint64_t(used.ru_utime.tv_sec) + std::uint64_t(used.ru_stime.tv_sec);
}

/// Beside what the driver itself has taken.
void limit(const Limits& limits) {
    // Less than the engine's thread has, so that what nearly overflows here does not there.
    const rlimit stack{4 << 20, RLIM_INFINITY};
    setrlimit(RLIMIT_STACK, &stack);
    signal(SIGXFSZ, SIG_IGN);  // a driver that keeps what it compiled does without
    apps::limit_this_process(address_space() + limits.memory_bytes, used_seconds() + 1 + limits.seconds);
}

/// Standard output only for the answer: what drivers print is dropped.
int take_standard_output() {
    const int answer = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3), nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere >= 0) dup2(nowhere, STDOUT_FILENO);
    return answer;
}

bool send(int to, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = write(to, bytes.data(), bytes.size());
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        bytes.remove_prefix(std::size_t(sent));
    }
    return true;
}

int run(const Limits& limits) {
    const int output = take_standard_output();
    const std::string input = all_input();
    const std::size_t begin = input.find('\n') + 1, length = std::strtoull(input.c_str(), nullptr, 10);
    if (begin == 0 || length > input.size() - begin) return 2;
    const std::string answer =
        opengl::tried_program(input.substr(begin, length), input.substr(begin + length), [&limits] { limit(limits); });
    // Never taken down: the end of the process does it faster and cannot crash.
    _exit(send(output, answer) ? 0 : 3);
}

}  // namespace
}  // namespace rakelight::shader_check

int main(int argc, char** argv) {
    rakelight::shader_check::Limits limits;
    if (!rakelight::shader_check::parse(argc, argv, limits)) {
        std::fputs("rakelight-shader-check is started by rakelight; use that\n", stderr);
        return 2;
    }
    try {
        return rakelight::shader_check::run(limits);
    } catch (...) {  // no memory: the reader says so
        return 1;
    }
}
