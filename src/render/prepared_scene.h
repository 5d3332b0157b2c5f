// SPDX-License-Identifier: Apache-2.0
// What every picture is drawn of.
#pragma once
#include <memory>

#include <rakelight/session.h>

#include "prepare/prepare.h"

namespace rakelight {

class PreparedScene {
public:
    Scene scene;
    PrepareOptions options;  ///< that it was made with
    /// What it was made of, where other poses can be made of that too: see has_bind_pose().
    std::shared_ptr<const BoundScene> bound;
    Rare<ScenePose> pose;  ///< that it stands in
    /// The lights are those of the picture, none where it has none: the default rig does not come in.
    bool has_chosen_lights = false;
};

/// Whether two scenes differ in nothing that prepare looks at.
bool are_prepared_alike(const Scene& a, const Scene& b);

/// Takes over what prepare does not look at: lights, cameras, fog, environment.
void take_surroundings(Scene& prepared, const Scene& scene);

/// `options`, with what the settings of a picture of the scene ask for.
PrepareOptions options_for(PrepareOptions options, const RenderSettings& settings, const Scene& scene);

/// The one way from a scene to what engines draw. @param scene  passed validate()
std::shared_ptr<PreparedScene> make_prepared(Scene scene, const PrepareOptions& options, const RenderSettings& settings,
                                             Context& context);

/// Another pose of the same scene. @param prepared  has `bound`
std::shared_ptr<PreparedScene> make_posed(const PreparedScene& prepared, const Rare<ScenePose>& pose, Context& context);

/// Draws this scene from now on; its owner is the session, which hands it to the engine uncopied.
void give(Session& session, std::shared_ptr<PreparedScene> scene);

/// A camera of the scene, by its node or placed, as engines take it in a picture of that aspect.
Camera camera_in_world(const Scene& scene, Camera camera, double aspect);

/// What the scene is lit by: its own lights, or the default rig that stands with the camera. Where paths are followed, surfaces
/// that shine are lights.
std::vector<Light> lights_of(const Scene& scene, const Camera& camera, RayMethod method);

}  // namespace rakelight
