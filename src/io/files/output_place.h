// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace rakelight::io {

/// Whether an output can have its name: folders that are missing are made when the file is.
/// @throws Error failed: something else has the name of such a folder, or the output is a folder
void check_output_place(const std::string& output);

}  // namespace rakelight::io
