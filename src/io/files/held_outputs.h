// SPDX-License-Identifier: Apache-2.0
// Several output files that appear together or not at all.
#pragma once
#include <deque>
#include <memory>
#include <string>

#include "io/files/made_folders.h"
#include "io/files/output_file.h"

namespace rakelight::io {

/// While this lives, files that the same thread commits (OutputFile::commit()) are whole but wait under their temporary names;
/// commit() renames them all. Without it they are removed. Devices and memory are written to at once. They do not nest.
class HeldOutputs {
public:
    HeldOutputs();
    ~HeldOutputs();
    HeldOutputs(const HeldOutputs&) = delete;
    HeldOutputs& operator=(const HeldOutputs&) = delete;

    /// Where one of them cannot be renamed, those before it get their old content back. @throws Error failed
    void commit();

    /// Of this thread; null: outputs are not held.
    static HeldOutputs* current();
    /// @param temporary  a finished file, which is no longer the caller's  @param path  what it is to be called
    /// @throws Error failed: another one of this name has other bytes; the caller keeps the file then
    void take(const std::string& temporary, const std::string& path, MadeFolders& folders);

private:
    struct Held {
        std::string temporary, path, backup{};  ///< backup: the old content while others are renamed; empty: none
        UnfinishedOutput unfinished{};          ///< of `temporary`
    };
    void put_in_place(Held& held);
    void put_back() noexcept;
    MadeFolders folders_;  ///< outlives what is in them
    std::deque<Held> files_;
    std::size_t renamed_ = 0;  ///< of files_, from the first
};

}  // namespace rakelight::io
