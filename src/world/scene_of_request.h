// SPDX-License-Identifier: Apache-2.0
// Applies a request to a loaded scene: materials, environment, clips.
#pragma once
#include <rakelight/request.h>

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

/// The scene at the moment of the requested clips.
/// @throws Error usage: see clips_of()
Scene with_requested_clips(Scene scene, const PictureRequest& request, Context& context);

/// A scene with the materials and the environment of a request.
Scene as_requested(Scene scene, const PictureRequest& request, Context& context);

/// Loads the model of a request and applies the request.
Scene scene_of_request(const PictureRequest& request, Context& context);

/// Index of a camera by number or name; a numeric name is found if no such index exists.
/// @throws Error usage: there is none
std::size_t find_camera(const Scene& scene, const std::string& wanted);

}  // namespace rakelight
