// SPDX-License-Identifier: Apache-2.0
// `rakelight view MODEL ...`: a window, which is another program.
#pragma once
#include <string>
#include <vector>

namespace rakelight::cli {

/// Whether there is a display, and the viewer beside this program or in PATH.
bool can_view();

/// Runs rakelight-view instead of this program with the words behind "view"; folders stand for the models in them.
/// @throws Error failed: it is not there; not_found: a folder without models
[[noreturn]] void become_viewer(const std::vector<std::string>& words, const std::vector<std::string>& models,
                                bool is_recursive);

}  // namespace rakelight::cli
