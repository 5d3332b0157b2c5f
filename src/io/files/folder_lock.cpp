// SPDX-License-Identifier: Apache-2.0
#include <rakelight_internal/io/folder_lock.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <optional>
#include <utility>

#include <rakelight/base/error.h>

#include "io/files/descriptor.h"
#include "io/files/made_folders.h"

namespace rakelight {
namespace {

constexpr int most_tries = 100;  ///< others may remove the folder as often before it is locked

[[noreturn]] void refuse(const std::string& folder, const std::string& reason) {
    throw Error(ErrorCode::failed, reason).with_file(folder);
}

/// Whether this name still leads to the folder that was opened.
bool has_name(int fd, const std::string& folder) {
    struct ::stat opened {
    }, named{};
    return ::fstat(fd, &opened) == 0 && ::stat(folder.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
           opened.st_dev == named.st_dev;
}

}  // namespace

struct FolderLock::State {
    std::optional<io::Descriptor> folder;
    std::optional<io::MadeFolders> made;  ///< removed before the lock is released
};

FolderLock::FolderLock(const std::string& folder) : state_(std::make_unique<State>()) {
    for (int tries = 0; tries < most_tries; ++tries) {
        state_->made.emplace().make_above(folder + "/.");
        state_->folder.emplace(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        const int fd = state_->folder->fd;
        if (fd < 0 && errno == ENOENT) continue;
        if (fd < 0) refuse(folder, "cannot be opened: " + io::system_message(errno));
        if (::flock(fd, LOCK_EX | LOCK_NB) != 0) {
            if (errno == EWOULDBLOCK) refuse(folder, "another process works in this folder");
            return;
        }
        if (has_name(fd, folder)) return;
    }
    refuse(folder, "is removed again and again");
}

FolderLock::~FolderLock() = default;

}  // namespace rakelight
