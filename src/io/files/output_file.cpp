// SPDX-License-Identifier: Apache-2.0
// Files that appear whole or not at all: a temporary name, on the disk, renamed, and the folder on the disk too. Beside
// them the file that is overwritten where it is.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/format_text.h"
#include "io/files/descriptor.h"
#include "io/files/held_outputs.h"
#include "io/files/output_file.h"

namespace rakelight::io {
namespace {

constexpr const char* cannot_be_written = "cannot be written";

[[noreturn]] void refuse_output(const std::string& path, int code, const std::string& what = cannot_be_written) {
    throw Error(ErrorCode::failed, what + ": " + system_message(code)).with_file(path);
}

/// With the slash at its end; empty: the working folder.
std::string folder_part(const std::string& path) {
    const std::size_t slash = path.find_last_of('/');
    return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

/// Where a symbolic link leads, relative to where `path` is relative to. @return false: `path` is no link
bool read_link(std::string& path) {
    std::array<char, PATH_MAX> target;
    const ssize_t length = ::readlink(path.c_str(), target.data(), target.size());
    if (length <= 0) return false;
    const std::string_view text(target.data(), std::size_t(length));
    path = text[0] == '/' ? std::string(text) : folder_part(path) + std::string(text);
    return true;
}

/// Creates a file in the folder of `path` under an unused name; a short one, so that it fits wherever `path` fits.
/// @return the descriptor, or -1 with errno
int create_beside(const std::string& path, std::string& temporary, UnfinishedOutput& unfinished) {
    static std::atomic<unsigned> counter{0};
    int fd = -1;
    do {  // a taken name was left by a dead process with the same id; the counter continues
        temporary = format_text("{}.rl-{}-{}.tmp", folder_part(path), ::getpid(), counter++);
        unfinished.watch(temporary);
        fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (fd < 0 && errno == EEXIST);
    return fd;
}

/// @return 0 or an errno. File systems that cannot do it say EINVAL, ENOTSUP or ENOSYS (fsync(2), POSIX): no fault of
/// the output.
int sync_to_disk(int fd) {
    int result = 0;
    do result = ::fsync(fd);
    while (result != 0 && errno == EINTR);
    if (result == 0 || errno == EINVAL || errno == ENOTSUP || errno == EOPNOTSUPP || errno == ENOSYS) return 0;
    return errno;
}

/// @return 0 or an errno
int write_all(int fd, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(fd, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return count < 0 ? errno : EIO;
        bytes = bytes.subspan(std::size_t(count));
    }
    return 0;
}

/// A device, a FIFO or a file, as it is. A FIFO that nobody reads would be waited for; where somebody does, writes wait
/// as usual. @return the descriptor, or -1 with errno
int open_as_it_is(const std::string& path, int flags = 0) {
    const int fd = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK | flags);
    if (fd >= 0) ::fcntl(fd, F_SETFL, ::fcntl(fd, F_GETFL) & ~O_NONBLOCK);
    return fd;
}

[[noreturn]] void refuse_open(const std::string& path, int code) {
    refuse_output(path, code, code == ENXIO ? "nobody reads from it" : cannot_be_written);
}

}  // namespace

void overwrite_file(const std::string& path, std::span<const std::byte> bytes) {
    Descriptor file{open_as_it_is(path, O_TRUNC)};
    if (file.fd < 0) refuse_open(path, errno);
    int code = write_all(file.fd, bytes);
    if (code != 0) static_cast<void>(!::ftruncate(file.fd, 0));
    const bool is_closed =
        ::close(std::exchange(file.fd, -1)) == 0;  // NFS and quotas may say only here that it is full
    if (code == 0 && !is_closed) {
        code = errno;
        static_cast<void>(!::truncate(path.c_str(), 0));
    }
    if (code != 0) refuse_output(path, code);
}

std::string behind_links(const std::string& path) {
    constexpr int most_links = 40;  // as Linux follows
    std::string target = path;
    for (int followed = 0; followed <= most_links; ++followed)
        if (!read_link(target)) return target;
    refuse_output(path, ELOOP);
}

void sync_file(const std::string& path) {
    const Descriptor opened{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
    if (opened.fd < 0) refuse_output(path, errno);
    if (const int code = sync_to_disk(opened.fd)) refuse_output(path, code);
}

void sync_folder(const std::string& folder) {
    const Descriptor opened{::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    if (opened.fd < 0) return;  // one may write into folders that one may not read
    if (const int code = sync_to_disk(opened.fd)) refuse_output(folder, code, "the folder cannot be written to disk");
}

OutputFile::OutputFile(const OutputTarget& target) : path_(target.path), memory_(target.memory) {
    if (memory_)
        open_memory();
    else
        open_file();
}

void OutputFile::open_memory() {
    file_ = ::open_memstream(&buffer_, &buffer_bytes_);
    if (file_ == nullptr) refuse_output(path_, errno);
}

void OutputFile::take_memory() {
    const auto* first = reinterpret_cast<const std::byte*>(buffer_);
    memory_->assign(first, first + buffer_bytes_);
}

void OutputFile::open_file() {
    if (path_.empty() || path_.find('\0') != std::string::npos)
        throw Error(ErrorCode::failed, "the name of the output file is empty or holds a zero byte");
    struct ::stat status {};
    const bool exists = ::stat(path_.c_str(), &status) == 0;
    if (!exists && errno != ENOENT) refuse_output(path_, errno);
    if (exists && S_ISDIR(status.st_mode)) refuse_output(path_, EISDIR);
    // Renaming over /dev/null or a FIFO would replace it: such targets are written to as they are.
    const bool direct = exists && !S_ISREG(status.st_mode);
    const std::string behind = direct ? path_ : behind_links(path_);
    if (!exists && behind == path_) folders_.make_above(path_);  // none for a link that leads nowhere
    path_ = behind;
    if (exists && ::stat(path_.c_str(), &status) != 0) refuse_output(path_, errno);  // /dev/stdout of a deleted file
    Descriptor file{direct ? open_as_it_is(path_) : create_beside(path_, temporary_, unfinished_)};
    if (file.fd < 0) refuse_open(path_, errno);
    if (exists && !direct) static_cast<void>(::fchmod(file.fd, status.st_mode & 0777));
    file_ = ::fdopen(file.fd, "wb");
    if (file_ == nullptr) {
        const int code = errno;
        if (!direct) ::unlink(temporary_.c_str());
        refuse_output(path_, code);
    }
    file.fd = -1;
}

OutputFile::~OutputFile() {
    if (file_ != nullptr) std::fclose(file_);
    std::free(buffer_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::write(std::span<const std::byte> bytes) {
    if (!bytes.empty() && std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size())
        refuse_output(path_, errno);
}

void OutputFile::finish(Sync sync) {
    // stdio keeps an earlier failure in ferror() only; fclose() alone may report success after it.
    const bool broken = std::fflush(file_) != 0 || std::ferror(file_) != 0;
    int code = broken ? errno : 0;
    // Before the rename: a crash soon after it would else leave a whole name with an empty file where an older one was.
    if (!broken && !temporary_.empty() && sync == Sync::now) code = sync_to_disk(::fileno(file_));
    if (std::fclose(std::exchange(file_, nullptr)) != 0 && code == 0) code = errno;
    if (broken || code != 0) refuse_output(path_, code != 0 ? code : EIO);
    if (memory_) take_memory();
}

void OutputFile::commit(Sync sync) {
    if (file_ != nullptr) finish(sync);
    if (temporary_.empty()) return;
    if (HeldOutputs* const held = HeldOutputs::current()) {
        held->take(temporary_, path_, folders_);
        temporary_.clear(), unfinished_.forget();
        return;
    }
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0) refuse_output(path_, errno);
    temporary_.clear();
    folders_.keep();
    if (sync == Sync::later) return;
    const std::string folder = folder_part(path_);
    sync_folder(folder.empty() ? "." : folder);
}

}  // namespace rakelight::io
