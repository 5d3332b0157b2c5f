// SPDX-License-Identifier: Apache-2.0
// Files in and out: bounded reading of untrusted files, references that stay in the model's folder, atomic writing.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <rakelight/context.h>

#include "io/files/sync.h"
#include "io/files/unfinished_output.h"

namespace rakelight::io {

using Bytes = std::shared_ptr<const std::vector<std::byte>>;

/// Bytes with what pays for them.
Bytes charged_bytes(std::vector<std::byte> bytes, MemoryCharge charge);

/// Reads a whole regular file (a link to one is fine). Tells the budget how much was read, and the context of the file.
/// @param is_told  the budget knows of this file already
/// @throws Error not_found: missing, a directory, a FIFO or device, unreadable, empty name; bad_file: over the memory limit.
///         The error carries `path` as its file.
Bytes read_file(const std::string& path, Context& context, bool is_told = false);

/// A regular file that is read piece by piece. Tells the context of the file.
class InputFile {
public:
    /// @throws Error not_found, as read_file()
    InputFile(std::string path, Context& context);
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;
    ~InputFile() { std::fclose(file_); }
    /// @return how many bytes were read; fewer than asked for at the end of the file. @throws Error not_found
    std::size_t read(std::span<std::byte> bytes);
    void seek(std::uint64_t position);
    std::uint64_t position() const { return std::uint64_t(std::ftell(file_)); }
    std::uint64_t size() const { return size_; }  ///< [bytes] when it was opened
    const std::string& path() const { return path_; }
    std::FILE* handle() { return file_; }  ///< for libraries that want a FILE*

private:
    std::string path_;
    std::uint64_t size_ = 0;
    std::FILE* file_ = nullptr;
};

/// True for an existing regular file.
bool is_regular_file(const std::string& path);

/// Where a reference inside a model points: `reference` (a relative path, as written; '\\' counts as '/') resolved against
/// the folder of `model_path`. Percent-encoding must be undone by the caller where the format has it.
/// @throws Error bad_file when it would leave the model's own folder tree (absolute, "..", through a symbolic link, another
///         scheme such as http:) unless `allow_outside`, or names a drive ("C:\\x"); the message has it as written.
std::string resolve_reference(const std::string& model_path, const std::string& reference, bool allow_outside);

/// Why a file that a model names is not used: " is not in the model's folder; " and what was done instead, or that it
/// lies outside of it and that 'allow-outside' permits it.
std::string why_not_found(const std::string& model_path, const std::string& reference, const std::string& done);

/// Bytes of a percent-encoded URI; nullopt when an escape is broken.
std::optional<std::string> percent_decode(const std::string& uri);

/// Bytes of base64 (RFC 4648, padding optional, no white space); nullopt when a character is illegal.
std::optional<std::vector<std::byte>> base64_decode(std::string_view text);

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

/// The missing folders above a file that is to be written, from the outermost. They are removed again, where they are empty,
/// unless the file was written.
class MadeFolders {
public:
    MadeFolders() = default;
    ~MadeFolders();
    MadeFolders(const MadeFolders&) = delete;
    MadeFolders& operator=(const MadeFolders&) = delete;
    /// @throws Error failed, with `path` as its file
    void make_above(const std::string& path);
    void keep();
    void give_to(MadeFolders& other);  ///< which removes them then

private:
    std::deque<std::string> folders_;          ///< those that were made
    std::deque<UnfinishedOutput> unfinished_;  ///< [folders]
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

}  // namespace rakelight::io
