// SPDX-License-Identifier: Apache-2.0
// What flat and Gouraud shading leave out.
#pragma once
#include <functional>

#include <rakelight/engines/engine.h>

#include "shading/draw_list.h"

namespace rakelight::shading {

/// At most one remark of a kind: normal and height maps, layers of pbr, and shadows do not act where lighting is evaluated
/// before there are pixels.
/// @param is_lit_at_corners  whether a draw is, and the picture shows it
void remark_corner_shading(const DrawList& list, const RenderSettings& settings,
                           const std::function<bool(std::uint32_t draw)>& is_lit_at_corners, Report& report);

}  // namespace rakelight::shading
