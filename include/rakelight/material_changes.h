// SPDX-License-Identifier: Apache-2.0
// Materials of a scene that is there, changed as world files change them.
#pragma once
#include <span>
#include <string>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/export.h>
#include <rakelight/scene.h>
#include <rakelight/world.h>

namespace rakelight {

/// Which materials of a scene are meant.
struct MaterialTarget {
    std::string name{};             ///< of the material; "*": any; "default": that of meshes that have none
    std::uint32_t node = no_index;  ///< that of this object alone; none: of all objects
    bool operator==(const MaterialTarget&) const = default;
};

/// Keys of [[material]] with their values, of material_values(); pictures are named as in MaterialOverrides.
struct MaterialChanges {
    MaterialTarget target{};
    std::vector<WorldValue> values{};
};

/// The scene with keys of [[material]] set, as a world file sets them: those of all objects first, then those of single
/// objects, which get materials and meshes of their own behind the scene's.
/// @throws Error usage; bad_file: see validate(); not_found, bad_file: a picture
RL_API Scene with_material_changes(Scene scene, std::span<const MaterialChanges> changes, Context& context);

/// The same of all materials of a name.
RL_API Scene with_material_values(Scene scene, const std::string& name, const std::vector<WorldValue>& values,
                                  Context& context);

}  // namespace rakelight
