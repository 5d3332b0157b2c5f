// SPDX-License-Identifier: Apache-2.0
// Loads a world file as one scene.
#pragma once
#include <utility>

#include <rakelight/io/world.h>
#include <rakelight/world/load.h>

namespace rakelight {

/// Loads every model of a world and assembles the scene. Mesh::normal_choice gets the normal options of each part, and
/// whether missing normals are flat.
/// @param path of the world file: names are relative to its folder and must stay in it unless `allow_outside`
/// @throws Error not_found, bad_file: with the place in the world file, also for faults of models
Scene load_world(const std::string& path, const WorldFile& world, const LoadOptions& options, Context& context);

/// The path of a picture named in a world; it is decoded once as a check.
/// @param path  of the world file
/// @param size [px] out: its width and height; may be null
/// @throws Error not_found, bad_file: with its name and place
std::string checked_picture(const std::string& path, const std::string& name, WorldPlace place,
                            const LoadOptions& options, Context& context, std::pair<int, int>* size = nullptr);

/// The part of the scene from one [[model]] or [[primitive]].
struct LoadedPart {
    const std::string& name;
    std::uint32_t first_material = 0, end_material = 0;  ///< in the scene; later ones are materials of the world
    std::uint32_t first_mesh = 0, end_mesh = 0;
    std::uint32_t first_node = 0, end_node = 0;
    const std::string& material;  ///< for the whole part, or empty
};

/// Applies [[material]] to the models' materials and creates materials of the world.
/// @param path  of the world file
void apply_materials(Scene& scene, const WorldFile& world, const std::vector<LoadedPart>& parts,
                     const std::string& path, const LoadOptions& options, Context& context);

}  // namespace rakelight
