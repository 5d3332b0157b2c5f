// SPDX-License-Identifier: Apache-2.0
// What the default look adds to an explained pixel: its choices, and the way from light to codes.
#pragma once
#include <string>
#include <vector>

#include "tools/explain/explain.h"

namespace rakelight {

/// What the look changed in a request, compared with the request before. @param engine opened on it
std::vector<LookChoice> look_choices(const PictureRequest& asked, const PictureRequest& looked,
                                     const raster::Inspection& engine);
/// The choices, and how the look's exposure acts; lines. Empty: there are none.
std::string look_text(const ExplainedPixel& e);
/// From light to codes where there is an exposure or a tone curve; lines, or nothing.
std::string code_text(const ExplainedPixel& e);

}  // namespace rakelight
