// SPDX-License-Identifier: Apache-2.0
// Words on a Canvas: digits and the letters that the axes and curves of plots need.
#pragma once
#include <string_view>

#include "tools/stages/canvas.h"

namespace rakelight::stages {

inline constexpr int label_height = 10, label_advance = 8;  ///< [px] of a character, and from one to the next

/// Characters are 6 x 10 px, (x, y) is the top left corner of the first. What has no picture (capitals, say) is a gap.
void label(Canvas& canvas, int x, int y, std::string_view text, Code color);

}  // namespace rakelight::stages
