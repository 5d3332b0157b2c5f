// SPDX-License-Identifier: Apache-2.0
// The view of what is drawn.
#pragma once
#include "shading/view.h"

namespace rakelight::raster {

using shading::ClipVertex;
using shading::View;

struct DrawList;
/// What camera and settings are for, both checked. Formats of the textbook's depth keep the camera's own range, which
/// they are there to show.
View view_of(const DrawList& list, const Camera& camera, const RenderSettings& settings);

}  // namespace rakelight::raster
