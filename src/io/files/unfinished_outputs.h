// SPDX-License-Identifier: Apache-2.0
// The list of current temporary files, in a form that a signal handler may read.
#pragma once
#include <string>

namespace rakelight::io {

/// A temporary file or, with nothing in it but such files, folder that remove_unfinished_outputs() removes as long as
/// this lives.
class UnfinishedOutput {
public:
    UnfinishedOutput() = default;
    ~UnfinishedOutput() { forget(); }
    UnfinishedOutput(const UnfinishedOutput&) = delete;
    UnfinishedOutput& operator=(const UnfinishedOutput&) = delete;
    /// Instead of the one before. Of more than 256 at once, the rest is not watched.
    void watch(const std::string& path);
    void forget() noexcept;

private:
    char* path_ = nullptr;  ///< on the heap, and in the table
};

}  // namespace rakelight::io
