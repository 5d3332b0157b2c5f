// SPDX-License-Identifier: Apache-2.0
// A world file as one scene.
#pragma once
#include <utility>

#include <rakelight/load.h>
#include <rakelight/world.h>

namespace rakelight {

/// Loads every model of a world and puts it together. What the world says of a part's normals stands in
/// Mesh::normal_choice, and so does what formats that mean flat faces do.
/// @param path  of the world file: names are resolved from its folder and stay in it unless `allow_outside`
/// @throws Error not_found, bad_file: with the place in the world file, a model's faults too
Scene load_world(const std::string& path, const WorldFile& world, const LoadOptions& options, Context& context);

/// The path of a picture that a world names, which was decoded once.
/// @param path  of the world file
/// @param size  [px] out: its width and height; null: not wanted
/// @throws Error not_found, bad_file: with its name and place
std::string checked_picture(const std::string& path, const std::string& name, WorldPlace place,
                            const LoadOptions& options, Context& context, std::pair<int, int>* size = nullptr);

/// What became of one [[model]] or [[primitive]].
struct LoadedPart {
    const std::string& name;
    std::uint32_t first_material = 0, end_material = 0;  ///< in the scene; those behind are the world's own
    std::uint32_t first_mesh = 0, end_mesh = 0;
    std::uint32_t first_node = 0, end_node = 0;
    const std::string& material;  ///< for all of it, or empty
};

/// Changes the models' materials as [[material]] says and makes the world's own.
/// @param path  of the world file
void apply_materials(Scene& scene, const WorldFile& world, const std::vector<LoadedPart>& parts,
                     const std::string& path, const LoadOptions& options, Context& context);

}  // namespace rakelight
