// SPDX-License-Identifier: Apache-2.0
// Chooses the camera of a picture. See choose_camera() in <rakelight/render/camera_chooser.h>.
#pragma once
#include <rakelight/base/report.h>
#include <rakelight/render/camera_chooser.h>
#include <rakelight/scene/scene_queries.h>
#include <rakelight/scene/validate.h>

namespace rakelight {

/// Functions of public headers for scenes that passed validate(), which the public ones do first.
namespace valid {
/// @param aspect  a number > 0
Camera choose_camera(const Scene& scene, const ViewRequest& view, double aspect, Visibility visibility,
                     Context& context);
}  // namespace valid

/// A camera of the file, in the world, for a picture of that aspect.
Camera camera_of_file(const Scene& scene, std::size_t index, double aspect);

/// The camera with square pixels in a picture of another aspect than its own: all that it shows stays in the picture.
Camera adapt_to_aspect(Camera camera, double aspect);

/// Whether a view is that of a camera of the file, moved or not. The scene has one then, or choose_camera() refuses the view.
bool takes_camera_of_file(const Scene& scene, const ViewRequest& view);

/// A horizontal angle alone becomes the vertical one of square pixels; both change `aspect` to that of what is seen.
ViewRequest resolve_angles(ViewRequest view, double& aspect);

}  // namespace rakelight
