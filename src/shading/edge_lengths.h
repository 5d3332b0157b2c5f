// SPDX-License-Identifier: Apache-2.0
// How large the triangles of a draw are in a picture.
#pragma once
#include "shading/draw_list.h"
#include "shading/picture_camera.h"

namespace rakelight::shading {

/// Whether no edge of a triangle that the whole picture (not only its window) may show is longer than so many pixels. False where
/// none is shown, and where one passes the near or far plane or reaches far out of the picture.
bool edges_are_within(const DrawList& list, const Draw& draw, const PictureCamera& view, double pixels);

}  // namespace rakelight::shading
