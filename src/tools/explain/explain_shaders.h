// SPDX-License-Identifier: Apache-2.0
// What shaders of the user's make of a pixel: the terms that a lighting returns, and those that it declares.
#pragma once
#include <string>

#include "render/remarks/shader_terms.h"
#include "tools/report_json.h"

namespace rakelight {

/// Lines.
std::string shaded_text(const ShadedPixel& shaded);
Json shaded_json(const ShadedPixel& shaded);

}  // namespace rakelight
