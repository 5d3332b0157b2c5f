// SPDX-License-Identifier: Apache-2.0
// Lines over a picture of the engine soft, as GlView::lines() draws them over one of OpenGL.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/engines/line.h>
#include <rakelight/scene/scene.h>

namespace rakelight::web {

/// @param codes  [width * height] sRGB codes, R in the low byte
/// @param depth  [width * height] of the picture by `camera`, in the world: surfaces hide lines
/// @param size   [m] of the model: ends that lie on a surface are seen in spite of rounding
void paint_lines(std::vector<std::uint32_t>& codes, std::span<const Line> lines, const Camera& camera,
                 std::span<const float> depth, int width, int height, double size);

}  // namespace rakelight::web
