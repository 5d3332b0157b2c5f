// SPDX-License-Identifier: Apache-2.0
// Applies a request to a loaded scene: materials, coloring, environment, preset.
#pragma once
#include <rakelight/world/request.h>

namespace rakelight {

namespace valid {
/// override_materials() for a validated scene.
Scene override_materials(Scene scene, const MaterialOverrides& overrides, Context& context);
}  // namespace valid

/// The scene with the environment of a request.
/// @throws Error not_found, bad_file: the picture cannot be read
Scene with_environment(Scene scene, const PictureRequest& request, Context& context);
/// Whether the environment lights the scene, so that the default rig is not used.
bool is_lit_by_environment(const Scene& scene);

/// A scene with the materials, the coloring, the environment and the preset of a request.
Scene with_requested_surfaces(Scene scene, const PictureRequest& request, Context& context);

/// Index of a camera by number or name; a numeric name is found if no such index exists.
/// @throws Error usage: there is none
std::size_t find_camera(const Scene& scene, const std::string& wanted);

}  // namespace rakelight
