// SPDX-License-Identifier: Apache-2.0
// Helper programs of Rakelight as child processes: found, started, read from until a deadline, and always ended afterwards.
#pragma once
#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rakelight {

class Context;

/// A helper program, and the words of errors about it.
struct HelperProgram {
    const char* file;      ///< "rakelight-import"
    const char* variable;  ///< of the environment, with its path
    const char* name;      ///< "import helper"
    const char* missing;   ///< why there must be one
    const char* advice;    ///< where there is none
};

/// `asked`, else that of the environment, else the one beside the running program or this library, or where it is installed as
/// counted from either.
/// @param asked  a path, or empty
/// @throws Error failed with advice when there is none.
std::string find_helper(const HelperProgram& program, const std::string& asked);

struct ChildStart {
    std::vector<std::string> words;      ///< the program and its arguments
    std::vector<std::string> variables;  ///< its environment: "NAME=value"
    int input = -1;                      ///< what it reads; -1: nothing
    double seconds = 8;                  ///< > 0; by the clock
};

/// Reads what a child writes. Destruction kills what still runs and leaves no zombie.
class ChildProcess {
public:
    /// @param name  HelperProgram::name @throws Error failed: it does not start
    ChildProcess(const std::string& name, ChildStart start);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;
    /// @param context  where cancellation is asked for; may be null
    /// @return bytes, 0 at the end; none: the time is over @throws Error failed, also cancelled
    std::optional<std::size_t> read(std::span<std::byte> to, Context* context);
    /// Waits for its end. @return the status of waitpid(); none: the time is over @throws Error failed: cancelled
    std::optional<int> wait(Context* context);

private:
    void kill_and_reap() noexcept;
    std::string name_;
    std::chrono::steady_clock::time_point deadline_;
    int pipe_ = -1;
    int child_ = -1;
};

/// ", SIGSEGV" and the like; empty for others.
const char* name_of_signal(int number);
/// "8 s", "0.3 s"
std::string seconds_text(double seconds);

}  // namespace rakelight
