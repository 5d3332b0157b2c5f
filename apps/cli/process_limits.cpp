// SPDX-License-Identifier: Apache-2.0
#include "process_limits.h"

#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <new>
#include <vector>

#include <rakelight_internal/io/unfinished_outputs.h>

#include "console.h"

namespace rakelight::cli {
namespace {

using namespace std::chrono_literals;

constexpr auto between_looks = 10ms;

/// The child processes of one thread; empty if the kernel does not report them.
std::vector<pid_t> children(pid_t thread) {
    std::ifstream list("/proc/self/task/" + std::to_string(thread) + "/children");
    std::vector<pid_t> out;
    for (pid_t child = 0; list >> child;) out.push_back(child);
    return out;
}

double seconds_of(timespec time) { return double(time.tv_sec) + double(time.tv_nsec) * 1e-9; }

/// The processor time of a running process; 0: there is none.
double cpu_seconds_of(pid_t process) {
    clockid_t clock{};
    timespec time{};
    return clock_getcpuclockid(process, &clock) == 0 && clock_gettime(clock, &time) == 0 ? seconds_of(time) : 0;
}

/// The processor time of the children that have ended.
double ended_cpu_seconds() {
    rusage use{};
    getrusage(RUSAGE_CHILDREN, &use);
    return double(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
           double(use.ru_utime.tv_usec + use.ru_stime.tv_usec) * 1e-6;
}

std::uint64_t bytes_of(pid_t process) {
    std::ifstream numbers("/proc/" + std::to_string(process) + "/statm");
    std::uint64_t whole = 0, resident = 0;
    numbers >> whole >> resident;
    return resident * std::uint64_t(sysconf(_SC_PAGESIZE));
}

std::string memory_reason(const Limits& limits) {
    return "it takes more than the " + std::to_string(limits.bytes >> 20) + "M of memory that it may";
}

/// Which limit is passed; empty: none.
std::string passed(const Limits& limits, pid_t starter, double seconds) {
    double cpu = cpu_seconds_of(getpid()) + ended_cpu_seconds();
    std::uint64_t bytes = bytes_of(getpid());
    for (const pid_t child : children(starter)) cpu += cpu_seconds_of(child), bytes += bytes_of(child);
    const std::string time = std::to_string(int(limits.cpu_seconds * 1000)) + " ms of processor time";
    const double until_end =
        2 * std::chrono::duration<double>(between_looks).count();  // the next look, and ending itself
    if (cpu + until_end > limits.cpu_seconds) return "it takes more than the " + time + " that it may";
    if (seconds > limits.seconds) return "it takes longer than " + std::to_string(int(limits.seconds)) + " s";
    return bytes > limits.bytes ? memory_reason(limits) : std::string();
}

[[noreturn]] void end_process(const std::string& line) {
    remove_unfinished_outputs();
    static_cast<void>(!write(STDERR_FILENO, line.data(), line.size()));
    _exit(1);
}

std::string line_of(const std::string& reason, const std::string& file) {
    return error_line(Error(ErrorCode::failed, reason).with_file(file));
}

}  // namespace

ProcessLimits::ProcessLimits(const Limits& limits, const std::string& file)
    : limits_(limits), starter_(gettid()), file_(file), memory_line_(line_of(memory_reason(limits), file)) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // whose own memory is more
    const rlimit most{limits.bytes, limits.bytes};
    setrlimit(RLIMIT_DATA, &most);  // fails where a lower one is there, which is as good
#endif
    thread_ = std::thread([this] { watch(); });
}

ProcessLimits::~ProcessLimits() {
    {
        const std::lock_guard lock(mutex_);
        is_over_ = true;
    }
    changed_.notify_one();
    thread_.join();
}

void ProcessLimits::watch() {
    using namespace std::chrono;
    const auto begun = steady_clock::now();
    std::unique_lock lock(mutex_);
    try {
        while (!changed_.wait_for(lock, between_looks, [this] { return is_over_; })) {
            const std::string reason = passed(limits_, starter_, duration<double>(steady_clock::now() - begun).count());
            if (!reason.empty()) end_process(line_of(reason, file_));
        }
    } catch (const std::bad_alloc&) {  // the hard limit holds for this thread too
        end_process(memory_line_);
    }
}

}  // namespace rakelight::cli
