// SPDX-License-Identifier: Apache-2.0
// Modifier keys during a drop: another program has the keyboard then, so that no key events come.
#pragma once

namespace rakelight::viewer {

/// Modifier bits (keys.h) that are down on the keyboard, whoever has it; none where the system does not tell. Needs a window.
int held_modifiers();

}  // namespace rakelight::viewer
