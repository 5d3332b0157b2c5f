// SPDX-License-Identifier: Apache-2.0
// What every picture is drawn of.
#pragma once
#include <rakelight/session.h>

namespace rakelight {

class PreparedScene {
public:
    Scene scene;
    PrepareOptions options;  ///< that it was made with
};

/// `options`, with what the settings of a picture ask for.
PrepareOptions options_for(PrepareOptions options, const RenderSettings& settings);

/// The one way from a scene to what engines draw. @param scene  passed validate()
std::shared_ptr<const PreparedScene> make_prepared(Scene scene, const PrepareOptions& options,
                                                   const RenderSettings& settings, Context& context);

/// A camera of the scene, by its node or placed, as engines take it in a picture of that aspect.
Camera camera_in_world(const Scene& scene, Camera camera, double aspect);

/// What the scene is lit by: its own lights, or the default rig that stands with the camera.
std::vector<Light> lights_of(const Scene& scene, const Camera& camera);

}  // namespace rakelight
