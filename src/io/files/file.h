// SPDX-License-Identifier: Apache-2.0
// Files in: bounded reading of untrusted files, and references that stay in the model's folder.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/context.h>

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

}  // namespace rakelight::io
