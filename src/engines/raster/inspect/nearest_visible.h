// SPDX-License-Identifier: Apache-2.0
// Where the model is, seen from a pixel that shows none of it.
#pragma once
#include <optional>

#include "engines/raster/inspect/inspection.h"

namespace rakelight::raster {

/// The pixel nearest to (x, y) that a surface shows at, and what is there. Of several at one distance the topmost, then the leftmost.
/// Where masks leave holes, the nearest 64 covered pixels are tried. Absent: there is none.
/// @throws Error failed: cancelled
std::optional<PixelExplanation> nearest_visible(const Inspection& of, int x, int y, Context& context);

}  // namespace rakelight::raster
