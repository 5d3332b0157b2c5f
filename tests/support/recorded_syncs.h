// SPDX-License-Identifier: Apache-2.0
// Calls of fsync() and rename() in this program, in their order: it defines them itself, which the linker prefers to
// libc's. For one source of a test program.
#pragma once
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rakelight::test {

/// What happens between its construction and destruction; threads must not write files meanwhile.
class RecordedSyncs {
public:
    RecordedSyncs() { current() = this; }
    ~RecordedSyncs() { current() = nullptr; }
    RecordedSyncs(const RecordedSyncs&) = delete;
    RecordedSyncs& operator=(const RecordedSyncs&) = delete;

    /// "sync NAME" or "rename NAME NAME", names without folders; temporary ones (".*") as "*".
    std::vector<std::string> calls;
    /// What fsync() of a file or folder gives in place of the real one; 0: success. Absent: the real one.
    std::function<std::optional<int>(const std::filesystem::path&)> fsync_error;

    static RecordedSyncs*& current() {
        static RecordedSyncs* recorder = nullptr;
        return recorder;
    }
    static std::string short_name(const std::filesystem::path& path) {
        const std::string name = path.filename().string();
        return name.starts_with(".") ? "*" : name;
    }
};

}  // namespace rakelight::test

extern "C" int fsync(int fd) {
    if (rakelight::test::RecordedSyncs* const recorder = rakelight::test::RecordedSyncs::current()) {
        std::error_code ignored;
        const std::filesystem::path path =
            std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(fd), ignored);
        recorder->calls.push_back("sync " + rakelight::test::RecordedSyncs::short_name(path));
        const std::optional<int> error = recorder->fsync_error ? recorder->fsync_error(path) : std::nullopt;
        if (error && *error != 0) return errno = *error, -1;
        if (error) return 0;
    }
    return int(::syscall(SYS_fsync, fd));
}

extern "C" __attribute__((visibility("default"))) int rename(const char* from, const char* to) noexcept {
    if (rakelight::test::RecordedSyncs* const recorder = rakelight::test::RecordedSyncs::current())
        recorder->calls.push_back("rename " + rakelight::test::RecordedSyncs::short_name(from) + " " +
                                  rakelight::test::RecordedSyncs::short_name(to));
    return int(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}
