// SPDX-License-Identifier: Apache-2.0
// What a request changes of a scene that was loaded: its materials and its environment.
#pragma once
#include <rakelight/request.h>

namespace rakelight {

namespace valid {
/// override_materials() for a scene that passed validate().
Scene override_materials(Scene scene, const MaterialOverrides& overrides, Context& context);
}  // namespace valid

/// The scene with what the request says of its environment. @throws Error not_found, bad_file: the picture cannot be
/// read
Scene with_environment(Scene scene, const PictureRequest& request, Context& context);
/// Then the default rig is not wanted.
bool is_lit_by_environment(const Scene& scene);

/// The scene with the clips that a request asks for at their moments. @throws Error usage: see clips_of()
Scene with_requested_clips(Scene scene, const PictureRequest& request);

/// A scene with the materials and the environment that a request asks for.
Scene as_requested(Scene scene, const PictureRequest& request, Context& context);

/// The model of a request, as it is asked for.
Scene scene_of_request(const PictureRequest& request, Context& context);

/// Index of the camera that is asked for by number or name; a name made of digits is found where no such number exists.
/// @throws Error usage: there is none
std::size_t find_camera(const Scene& scene, const std::string& wanted);

}  // namespace rakelight
