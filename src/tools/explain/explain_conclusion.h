// SPDX-License-Identifier: Apache-2.0
// The last line of an explained pixel: which term makes most of it, and of a dark one what keeps the lights away.
#pragma once
#include <string>

#include "tools/explain/explain.h"

namespace rakelight {

/// "0 (directional, sun)"
std::string name_of_light(const ExplainedPixel& e, std::size_t light);
/// Which term contributes most to the pixel; for a dark one the factors that make it dark. A line.
std::string conclusion_text(const ExplainedPixel& e);

}  // namespace rakelight
