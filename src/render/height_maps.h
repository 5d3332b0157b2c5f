// SPDX-License-Identifier: Apache-2.0
// Height maps for materials that need a relief but have none.
#pragma once
#include <rakelight/engines/engine.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Computes a height map (image/height_from_normals.h) for every material whose bump technique reads heights and that
/// has a normal map but no height map. Each is reported, with the depth that follows from the normals. A map that
/// cannot be decoded is reported too, and its material is unchanged. Warns if the picture's technique reads heights
/// and no material has any, or if a material's own technique does and it has none.
Scene with_height_maps(Scene scene, const RenderSettings& settings, Context& context);

}  // namespace rakelight
