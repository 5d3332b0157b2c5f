// SPDX-License-Identifier: Apache-2.0
// For runs that somebody waits for and that must not cost more than they are worth: thumbnails.
#pragma once
#include <sys/types.h>

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

namespace rakelight::cli {

struct Limits {
    double cpu_seconds;   ///< of all threads, and of the programs that this one has started
    double seconds;       ///< of the clock, so that nothing waits for ever
    std::uint64_t bytes;  ///< of memory in use, with the programs that this one has started
};

/// While it lives, a thread looks every 10 ms at what this process takes. Past a limit, of processor time shortly
/// before it, it removes unfinished outputs, says which limit it was in a line on standard error, and ends the process
/// with exit code 1. Memory also has a hard limit of the same size, for large requests at once. Then the program says
/// that there is no memory. The thread, if it gets none itself, says that the limit is passed.
class ProcessLimits {
public:
    /// @param file  for the line
    ProcessLimits(const Limits& limits, const std::string& file);
    ~ProcessLimits();
    ProcessLimits(const ProcessLimits&) = delete;
    ProcessLimits& operator=(const ProcessLimits&) = delete;

private:
    void watch();

    Limits limits_;
    pid_t starter_;  ///< the thread that this was made in, which is who starts programs
    std::string file_;
    std::string memory_line_;  ///< made while there is memory
    std::mutex mutex_;
    std::condition_variable changed_;
    bool is_over_ = false;
    std::thread thread_;
};

}  // namespace rakelight::cli
