// SPDX-License-Identifier: Apache-2.0
// Height maps for materials that are to have a relief and have none.
#pragma once
#include <rakelight/engine.h>
#include <rakelight/scene.h>

namespace rakelight {

/// The scene where every material whose bump technique reads heights, and that has a normal map but no height map, has
/// one made from it (image/height_from_normals.h). Each is said in the report, with the depth that the normals speak
/// of; so is a map that cannot be decoded, whose material stays as it is. A warning where the picture's technique reads
/// heights and no material has any, or a material's own does and it has none.
Scene with_height_maps(Scene scene, const RenderSettings& settings, Context& context);

}  // namespace rakelight
