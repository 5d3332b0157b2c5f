// SPDX-License-Identifier: Apache-2.0
// Writes whole files.
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include <rakelight/base/export.h>

namespace rakelight {

/// Checks that a file can be written. Call it before long work.
/// @throws Error failed, with the file
RL_API void check_text_output(const std::string& path);

/// How a file gets its content.
enum class Saving {
    atomic,  ///< a new file replaces an older one when it is complete: the file appears complete or not at all
    /// An older file keeps its place and permissions, and what cannot be written completely is left empty. For file
    /// managers: they make the file themselves, and may run programs in a sandbox that can write this file, but can
    /// neither make another one beside it nor rename one over it. Without an older file as `atomic`. A FIFO that nobody
    /// reads from is an error.
    in_place,
};

/// Writes a file.
/// @throws Error failed, with the file
RL_API void save_bytes(const std::string& path, std::span<const std::byte> bytes, Saving saving);

/// Writes a text file, atomically.
/// @throws Error failed, with the file
RL_API void save_text(const std::string& path, const std::string& text);

}  // namespace rakelight
