// SPDX-License-Identifier: Apache-2.0
// Windows over the picture: the status at the bottom, the sheet of keys.
#pragma once
#include "panels.h"

namespace rakelight::viewer {

/// The file's name, times, what runs, messages.
void draw_status(const PanelView& view);
/// Every key and what it does, and the mouse.
void draw_help(PanelView& view);

}  // namespace rakelight::viewer
