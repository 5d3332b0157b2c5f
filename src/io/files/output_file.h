// SPDX-License-Identifier: Apache-2.0
// Files out: atomic writing, through links, onto the disk.
#pragma once
#include <cstddef>
#include <cstdio>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <rakelight/base/error.h>

#include "io/files/made_folders.h"
#include "io/files/sync.h"

namespace rakelight::io {

/// Where the pixels of a picture file lie in the whole picture, of which it may be a window [px].
struct ImagePlace {
    int x = 0, y = 0;           ///< of the file's top left pixel
    int width = 0, height = 0;  ///< of the whole picture; 0: not known, or the file is the whole
    bool operator==(const ImagePlace&) const = default;
};

/// Where an output goes: a file, or memory.
struct OutputTarget {
    OutputTarget(std::string file) : path(std::move(file)) {}  // NOLINT(google-explicit-constructor): mostly files
    OutputTarget(const char* file) : path(file) {}             // NOLINT(google-explicit-constructor): likewise
    OutputTarget(std::string name, std::vector<std::byte>& bytes) : path(std::move(name)), memory(&bytes) {}
    std::string path;                          ///< of the file; in memory: for messages
    std::vector<std::byte>* memory = nullptr;  ///< lives as long as the output
    std::string comment{};  ///< ASCII, into the metadata of PNG, JPEG, EXR and HDR files; empty: none
    ImagePlace place{};     ///< of a picture, into the metadata of PNG, EXR and HDR files
    bool is_data = false;   ///< PNG: numbers, not colors, are not tagged as sRGB
};

/// A file written under a temporary name beside its destination, and renamed when it is complete and on the disk;
/// removed if never committed. Folders above it that are missing are made. In memory the bytes appear when whole.
/// Symbolic links are followed, also to a file that does not exist yet. Devices and pipes are written to as they are.
class OutputFile {
public:
    /// @throws Error failed: the folder cannot be made or is not writable, the path is a folder, links that lead in a circle.
    explicit OutputFile(const OutputTarget& target);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    void write(std::span<const std::byte> bytes);  ///< @throws Error failed: disk full
    void finish(Sync sync = Sync::now);  ///< flush, fsync, close: what may fail for want of space; @throws Error failed
    /// Finish where that was not done, rename, fsync of the folder; among HeldOutputs the last two are theirs.
    /// @throws Error failed; the file may then be in its place
    void commit(Sync sync = Sync::now);
    std::FILE* handle() { return file_; }  ///< for libraries that want a FILE*

private:
    void open_memory();
    void open_file();
    void take_memory();
    std::string path_, temporary_;
    MadeFolders folders_;          ///< outlives what is in them
    UnfinishedOutput unfinished_;  ///< of temporary_
    std::FILE* file_ = nullptr;
    std::vector<std::byte>* memory_;  ///< null: a file
    char* buffer_ = nullptr;          ///< of the stream to memory, for free()
    std::size_t buffer_bytes_ = 0;
};

/// Output goes through symbolic links, not over them: the name of what `path` leads to, which need not be there.
/// @throws Error failed: links that lead in a circle
std::string behind_links(const std::string& path);

/// The bytes of a file that was written are on the disk. @throws Error failed: as sync_folder(); it cannot be opened
void sync_file(const std::string& path);

/// Names that were made or renamed in a folder stay after a crash of the machine; where the folder cannot be opened,
/// nothing.
/// @throws Error failed: EIO and the like, but not where the file system does not offer it
void sync_folder(const std::string& folder);

/// The way around OutputFile, for an output that cannot be renamed into its place: replaces the content of a file that is there, or writes to a device or FIFO. A file that cannot be written completely
/// is left empty.
/// @throws Error failed; a FIFO that nobody reads from, too
void overwrite_file(const std::string& path, std::span<const std::byte> bytes);

}  // namespace rakelight::io
