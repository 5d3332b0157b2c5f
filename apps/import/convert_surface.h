// SPDX-License-Identifier: Apache-2.0
// Materials and embedded pictures of an aiScene -> the records of stream_format.h.
#pragma once
#include <assimp/scene.h>

#include "source_format.h"

namespace rakelight::import_helper {

void convert_surfaces(const aiScene& scene, const Format& format, Document& out);

}  // namespace rakelight::import_helper
