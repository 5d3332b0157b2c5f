// SPDX-License-Identifier: Apache-2.0
// Materials of a look: which objects an edit means, and what it says.
#pragma once
#include "document.h"

namespace rakelight::viewer {

/// Sets a key of [[material]], as "roughness=0.5" says it. @throws Error usage
void set_material(Look& look, const MaterialTarget& target, const std::string& key_and_value);
/// The values that were set for a target; null: none.
const std::vector<WorldValue>* edited_values(const Look& look, const MaterialTarget& target);
void forget_material(Look& look, const MaterialTarget& target);

/// The model's scene with edited materials. @throws Error as with_material_changes()
Scene with_edits(Scene scene, const std::vector<MaterialEdit>& edits, Context& context);

/// The name by which [[material]] knows a material; empty: it has none.
std::string material_name(const Scene& scene, std::uint32_t material);
/// The material of the file that a material of a picture comes from: edited objects have copies behind those of the
/// file.
/// @param material  as channel_material gives it, in a picture with these edits
std::uint32_t source_material(const Scene& scene, const std::vector<MaterialEdit>& edits, std::uint32_t material);

/// All objects that have the material, by its name; where it has no name that of this object alone.
MaterialTarget target_of(const Scene& scene, std::uint32_t material, std::uint32_t node);
/// That of one object: all its materials where this one has no name.
MaterialTarget target_in_object(const Scene& scene, std::uint32_t material, std::uint32_t node);
/// "red", "red of left"
std::string title_of(const Scene& scene, const MaterialTarget& target);
/// "left", "node 3"
std::string object_title(const Scene& scene, std::uint32_t node);

/// Objects (nodes) that have a material, by its number in the file. no_index: of meshes without a material.
std::vector<std::uint32_t> objects_with(const Scene& scene, std::uint32_t material);

/// How a world file names an object: `model` empty for a scene that is no world's.
struct ObjectInWorld {
    std::string model, object;
};
/// @throws Error usage: there is no such node
ObjectInWorld object_in_world(const Scene& scene, std::uint32_t node);

/// The object of a scene that was reloaded whose name in a world file is that of an object before; no_index: it is gone. Objects
/// that are told by numbers keep theirs, if their names, or that they have none, are the same.
std::uint32_t same_object(const Scene& from, std::uint32_t node, const Scene& to);
/// Edits for a scene that was reloaded. @return titles of those whose object is gone; they are dropped
std::vector<std::string> carry_edits(std::vector<MaterialEdit>& edits, const Scene& from, const Scene& to);

}  // namespace rakelight::viewer
