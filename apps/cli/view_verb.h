// SPDX-License-Identifier: Apache-2.0
// `rakelight view`: starts the viewer, which is a program of its own, so that this one runs where no window can be.
#pragma once

namespace rakelight::cli {

/// Whether a command line is `rakelight MODEL`: a file, or a built-in shape, in the place of a command, where there is a display.
bool is_model_to_view(int argc, const char* const* argv);

/// Becomes rakelight-view with the words from number `first`: the one beside this program, else the one of PATH.
/// @throws Error failed: there is none
[[noreturn]] void become_viewer(int argc, const char* const* argv, int first);

}  // namespace rakelight::cli
