// SPDX-License-Identifier: Apache-2.0
#include "io/import/helper_process.h"

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>

#include "base/format_text.h"

namespace rakelight::io {
namespace {

constexpr HelperProgram program = {"rakelight-import", "RAKELIGHT_IMPORT", "import helper",
                                   "this format needs the program rakelight-import, which is not there",
                                   "put it beside the program, set RAKELIGHT_IMPORT, or export glTF"};

/// The environment variables of the helper: the C locale for numbers, and what loading it may need.
std::vector<std::string> helper_environment() {
    std::vector<std::string> variables{"LC_ALL=C", "MALLOC_ARENA_MAX=1"};
    for (const char* name : {"LD_LIBRARY_PATH", "ASAN_OPTIONS", "UBSAN_OPTIONS"})
        if (const char* value = std::getenv(name)) variables.push_back(std::string(name) + "=" + value);
    return variables;
}

ChildStart start_of(const std::string& helper, const std::string& model, const HelperLimits& limits) {
    const auto cpu_seconds = static_cast<long long>(std::ceil(std::min(limits.seconds, 1e6))) + 1;
    return {.words = {helper, "--memory", std::to_string(limits.memory_bytes), "--seconds", std::to_string(cpu_seconds),
                      "--outside", limits.allow_outside ? "1" : "0", "--", model},
            .variables = helper_environment(),
            .seconds = limits.seconds};
}

[[noreturn]] void too_slow(double seconds) {
    throw Error(ErrorCode::bad_file, "reading it took longer than " + seconds_text(seconds) + " and was stopped", {},
                "export glTF instead");
}

}  // namespace

std::string find_import_helper(const std::string& asked) { return find_helper(program, asked); }

HelperProcess::HelperProcess(const std::string& helper, const std::string& model, const HelperLimits& limits,
                             Context& context)
    : context_(context), limits_(limits), child_(program.name, start_of(helper, model, limits)) {}

void HelperProcess::read(std::span<std::byte> to) {
    while (!to.empty()) {
        const std::optional<std::size_t> got = child_.read(to, &context_);
        if (!got) too_slow(limits_.seconds);
        if (*got == 0) ended_early();
        to = to.subspan(*got);
    }
}

void HelperProcess::ended_early() {
    const std::optional<int> status = child_.wait(&context_);
    if (!status || (WIFSIGNALED(*status) && WTERMSIG(*status) == SIGXCPU)) too_slow(limits_.seconds);
    if (WIFSIGNALED(*status)) {
        const int number = WTERMSIG(*status);
        throw Error(ErrorCode::bad_file,
                    format_text("the import helper crashed (signal {}{}) on this file", number, name_of_signal(number)),
                    {}, "the file may be broken; export glTF instead");
    }
    throw Error(ErrorCode::bad_file, format_text("the import helper ended early (exit code {})",
                                                 WIFEXITED(*status) ? WEXITSTATUS(*status) : -1));
}

}  // namespace rakelight::io
