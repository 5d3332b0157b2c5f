// SPDX-License-Identifier: Apache-2.0
// Changes the materials of a scene like [[material]] of world files.
#pragma once
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>
#include <rakelight/io/world.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Selects materials of a scene.
struct MaterialTarget {
    std::string name{};  ///< name of a material; "*": all materials; "default": the material of meshes without one
    std::uint32_t node = no_index;  ///< only the materials of this object; no_index: the materials of all objects
    bool operator==(const MaterialTarget&) const = default;
};

/// Keys of [[material]] with their values, see material_values(); pictures are named as in MaterialOverrides.
struct MaterialChanges {
    MaterialTarget target{};
    std::vector<WorldValue> values{};
};

/// The scene with keys of [[material]] set as in a world file. Changes for all objects are applied first, then changes
/// for single objects. For a change of a single object, new materials and meshes are added at the end of the scene's
/// tables.
/// @throws Error usage; bad_file: an invalid scene (see validate()); not_found, bad_file: a picture
RL_API Scene with_material_changes(Scene scene, std::span<const MaterialChanges> changes, Context& context);

/// The same for all materials of a name.
RL_API Scene with_material_values(Scene scene, const std::string& name, const std::vector<WorldValue>& values,
                                  Context& context);

}  // namespace rakelight
