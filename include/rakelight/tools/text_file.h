// SPDX-License-Identifier: Apache-2.0
// Text that goes to a file: it appears under its name when it is whole.
#pragma once
#include <string>

#include <rakelight/export.h>

namespace rakelight {

/// What is in the way of a file, before any work. @throws Error failed, with the file
RL_API void check_text_output(const std::string& path);

/// @throws Error failed, with the file
RL_API void save_text(const std::string& path, const std::string& text);

}  // namespace rakelight
