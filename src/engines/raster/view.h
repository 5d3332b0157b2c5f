// SPDX-License-Identifier: Apache-2.0
// The view of what is drawn.
#pragma once
#include "shading/view.h"

namespace rakelight::raster {

using shading::ClipVertex;
using shading::View, shading::view_of;

}  // namespace rakelight::raster
