// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/programs/shader_check.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <mutex>
#include <set>
#include <string_view>

#include <rakelight/base/error.h>

#include "base/child_process.h"
#include "base/format_text.h"
#include "engines/opengl/programs/trial.h"

extern char** environ;  // POSIX declares it nowhere

namespace rakelight::opengl {
namespace {

constexpr HelperProgram program = {"rakelight-shader-check", "RAKELIGHT_SHADER_CHECK", "shader check",
                                   "GLSL texts need the program rakelight-shader-check, which is not there",
                                   "put it beside the program, or set RAKELIGHT_SHADER_CHECK"};
constexpr std::size_t most_answer = 8192;  ///< [bytes]
constexpr double seconds_by_clock = 4.0 * shader_check_seconds;

/// The same driver as here, but it writes no files.
std::vector<std::string> variables_of_check() {
    std::vector<std::string> variables{"LC_ALL=C", "MALLOC_ARENA_MAX=1", "MESA_SHADER_CACHE_DISABLE=true",
                                       "__GL_SHADER_DISK_CACHE=0"};
    const std::size_t own = variables.size();
    for (char** variable = environ; *variable; ++variable) {
        const std::string_view name = std::string_view(*variable).substr(0, std::string_view(*variable).find('='));
        bool is_set = false;
        for (std::size_t i = 0; i < own; ++i)
            is_set |= std::string_view(variables[i]).starts_with(std::string(name) + "=");
        if (!is_set) variables.emplace_back(*variable);
    }
    return variables;
}

/// A file in memory with what the check reads: the length of the vertices' text, a line feed, both texts.
class Question {
public:
    explicit Question(const ProgramText& text) : file_(::memfd_create("shader", MFD_CLOEXEC)) {
        if (file_ < 0) fail();
        write(std::to_string(text.vertices.text.size()) + "\n" + text.vertices.text + text.pixels.text);
        if (::lseek(file_, 0, SEEK_SET) != 0) fail();
    }
    ~Question() { close(); }
    Question(const Question&) = delete;
    Question& operator=(const Question&) = delete;
    int file() const { return file_; }

private:
    [[noreturn]] void fail() {
        const std::string why = std::strerror(errno);
        close();
        throw Error(ErrorCode::failed, "no memory for the shader check: " + why);
    }
    void close() {
        if (file_ >= 0) ::close(file_);
    }
    void write(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(file_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) fail();
            bytes.remove_prefix(std::size_t(written));
        }
    }
    int file_;
};

[[noreturn]] void too_slow() {
    throw Error(ErrorCode::bad_file,
                format_text("it takes the OpenGL driver more than {} s to compile it", shader_check_seconds));
}

/// The end of a check that has not answered. Drivers without memory raise a signal or exit with 1; other exits are its
/// own.
[[noreturn]] void ended_early(std::optional<int> status) {
    if (!status || (WIFSIGNALED(*status) && WTERMSIG(*status) == SIGXCPU)) too_slow();
    if (WIFEXITED(*status) && WEXITSTATUS(*status) != 1)
        throw Error(ErrorCode::failed, format_text("the shader check ends with exit code {}", WEXITSTATUS(*status)));
    throw Error(ErrorCode::bad_file,
                format_text("the OpenGL driver needs more than {} MiB to compile it, or crashes on it",
                            shader_check_bytes >> 20));
}

[[noreturn]] void refuse_answer() {
    throw Error(ErrorCode::failed, "the shader check answers something else than it may");
}

std::string answer_to(const ProgramText& text) {
    const Question question(text);
    const std::string path = find_helper(program, {});
    ChildProcess check(program.name, {.words = {path, "--memory", std::to_string(shader_check_bytes), "--seconds",
                                                std::to_string(shader_check_seconds)},
                                      .variables = variables_of_check(),
                                      .input = question.file(),
                                      .seconds = seconds_by_clock});
    std::string answer;
    char bytes[1024];
    for (;;) {
        const std::optional<std::size_t> got = check.read(std::as_writable_bytes(std::span(bytes)), nullptr);
        if (!got) too_slow();
        if (*got == 0) break;
        answer.append(bytes, *got);
        if (answer.size() > most_answer) refuse_answer();
    }
    const std::optional<int> status = check.wait(nullptr);
    if (!status || !WIFEXITED(*status) || WEXITSTATUS(*status) != 0) ended_early(status);
    return answer;
}

std::optional<CompileFault> fault_in(const std::string& answer) {
    const std::size_t end = std::min(answer.find('\n'), answer.size());
    const std::string_view word = std::string_view(answer).substr(0, end);
    std::string log = answer.substr(std::min(end + 1, answer.size()));
    if (word == trial_good) return {};
    if (word == trial_pixels) return CompileFault{CompileFault::Part::pixels, std::move(log)};
    if (word == trial_vertices) return CompileFault{CompileFault::Part::vertices, std::move(log)};
    if (word == trial_link) return CompileFault{CompileFault::Part::both, std::move(log)};
    if (word == trial_no_context) throw Error(ErrorCode::failed, "the shader check has no OpenGL: " + log);
    refuse_answer();
}

}  // namespace

std::optional<CompileFault> checked_apart(const ProgramText& text) {
    static std::mutex mutex;
    static std::set<std::string> good;  // whole texts: two with one hash may be anybody's
    const std::string both = text.vertices.text + '\0' + text.pixels.text;
    {
        const std::lock_guard lock(mutex);
        if (good.contains(both)) return {};
    }
    std::optional<CompileFault> fault = fault_in(answer_to(text));
    const std::lock_guard lock(mutex);
    if (!fault) {
        if (good.size() >= 64) good.clear();
        good.insert(both);
    }
    return fault;
}

}  // namespace rakelight::opengl
