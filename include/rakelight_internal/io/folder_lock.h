// SPDX-License-Identifier: Apache-2.0
// A folder that one process at a time works in.
#pragma once
#include <memory>
#include <string>

#include <rakelight/base/export.h>

namespace rakelight {

/// Holds a lock on a folder, which the system releases when the process ends, however it ends. Where the file system has
/// no locks for folders, as NFS, nothing is locked. Missing folders are created, and removed again if they stay empty.
class RL_API FolderLock {
public:
    /// @throws Error failed: the folder cannot be created; another process, or another part of this one, holds its lock
    explicit FolderLock(const std::string& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rakelight
