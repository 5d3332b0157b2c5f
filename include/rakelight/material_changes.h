// SPDX-License-Identifier: Apache-2.0
// Materials of a scene that is there, changed as world files change them.
#pragma once
#include <string>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/scene.h>
#include <rakelight/world.h>

namespace rakelight {

/// The scene with keys of [[material]] set on all materials of a name, as a world file sets them. "default" is the material of
/// meshes that have none; pictures are named as in MaterialOverrides.
/// @param values  of material_values() @throws Error usage; bad_file: see validate(); not_found, bad_file: a picture
Scene with_material_values(Scene scene, const std::string& name, const std::vector<WorldValue>& values,
                           Context& context);

}  // namespace rakelight
