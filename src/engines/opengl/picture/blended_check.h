// SPDX-License-Identifier: Apache-2.0
// Whether drawing blended triangles one after the other shows them as they lie.
#pragma once
#include "engines/opengl/picture/blended.h"

namespace rakelight::opengl {

/// Some triangle is drawn before one that lies behind it on more than a pixel: they cross, or no order of whole triangles
/// is right. Looks at a bounded number of triangles and pairs, and only at triangles wholly before the near plane.
/// @param runs  all blended triangles that may be seen, as they are drawn
bool has_wrong_order(const shading::DrawList& list, const shading::PictureCamera& view, const RenderSettings& settings,
                     const std::vector<BlendedRun>& runs);

}  // namespace rakelight::opengl
