// SPDX-License-Identifier: Apache-2.0
// Blended triangles of all draws in the order in which they are laid, far to near (shading::blending_place()).
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/base/context.h>

#include "shading/draw_list.h"
#include "shading/picture_camera.h"

namespace rakelight::opengl {

/// Triangles of one draw that follow one another in the order.
struct BlendedRun {
    std::uint32_t draw;
    std::vector<std::uint32_t> triangles;
};

/// @param draws  those that are blended and may be seen
std::vector<BlendedRun> blending_order(const shading::DrawList& list, const shading::PictureCamera& view,
                                       const std::vector<std::uint32_t>& draws, Context& context);

}  // namespace rakelight::opengl
