// SPDX-License-Identifier: Apache-2.0
// Changes the materials of a scene: all of them, or those of a name like [[material]] of world files.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>
#include <rakelight/io/world.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Overrides for every material of a scene. The textures use set 0 of the texture coordinates.
struct MaterialOverrides {
    std::string base_color{}, normal{}, height{};  ///< picture files; empty: the model's own
    std::optional<double> normal_scale{};          ///< Material::normal_scale
    std::optional<bool> green_down{};              ///< Material::green_down
    std::optional<bool> centered_normals{};        ///< Material::centered_normals
    std::optional<vec3> color{};                   ///< linear; base color factor
    std::optional<double> opacity{};               ///< 0..1, alpha factor; surfaces are blended if less than 1
    /// 0..1, factors of metallic-roughness materials; classical materials are converted first.
    std::optional<double> roughness{}, metallic{};
    /// Keys of [[material]] in world files, see material_values(). Applied after the picture files above, and before
    /// the other members.
    std::vector<WorldValue> values{};

    bool operator==(const MaterialOverrides&) const = default;
};

/// The scene with overridden materials; meshes without a material get one.
/// @throws Error not_found: a missing picture file, or a folder; bad_file: a picture that cannot be decoded
RL_API Scene override_materials(const Scene& scene, const MaterialOverrides& overrides, Context& context);

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

}  // namespace rakelight
