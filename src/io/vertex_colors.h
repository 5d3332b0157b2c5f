// SPDX-License-Identifier: Apache-2.0
// What vertex colors multiply where the file gives its materials no color.
#pragma once
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight::io {

/// Makes materials white for meshes with vertex colors, so that these are shown as the file has them. A material that
/// other meshes use too keeps its color for those; the meshes with vertex colors get a white copy of it.
/// @param is_invented  [materials] the file does not give the color of the material
void show_vertex_colors(Scene& scene, const std::vector<bool>& is_invented, Context& context);

}  // namespace rakelight::io
