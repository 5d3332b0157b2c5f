// SPDX-License-Identifier: Apache-2.0
// Writes text files atomically: a file appears complete or not at all.
#pragma once
#include <string>

#include <rakelight/export.h>

namespace rakelight {

/// Checks that a file can be written. Call it before long work.
/// @throws Error failed, with the file
RL_API void check_text_output(const std::string& path);

/// Writes a text file.
/// @throws Error failed, with the file
RL_API void save_text(const std::string& path, const std::string& text);

}  // namespace rakelight
