// SPDX-License-Identifier: Apache-2.0
// The way around OutputFile (file.h), for an output that cannot be renamed into its place.
#pragma once
#include <cstddef>
#include <span>
#include <string>

namespace rakelight::io {

/// Replaces the content of a file that is there, or writes to a device or FIFO. A file that cannot be written completely
/// is left empty.
/// @throws Error failed; a FIFO that nobody reads from, too
void overwrite_file(const std::string& path, std::span<const std::byte> bytes);

}  // namespace rakelight::io
