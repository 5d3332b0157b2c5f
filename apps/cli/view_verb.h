// SPDX-License-Identifier: Apache-2.0
// `rakelight view`: starts the viewer, which is a program of its own, so that this one runs where no window can be.
#pragma once

namespace rakelight::cli {

/// Becomes rakelight-view with the words behind `view`: the one beside this program, else the one of PATH.
/// @throws Error failed: there is none
[[noreturn]] void become_viewer(int argc, const char* const* argv);

}  // namespace rakelight::cli
