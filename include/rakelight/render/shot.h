// SPDX-License-Identifier: Apache-2.0
// From a loaded scene to a picture, step by step: decide() once, then plan_shot() and Session::render() for each picture.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/engines/engine.h>
#include <rakelight/scene/motion.h>
#include <rakelight/world/request.h>

namespace rakelight {

class Session;

/// One picture of a session: where it is seen from, how it is drawn, by what it is lit.
struct Shot {
    Camera camera{};  ///< at a node of the scene, or placed in world space
    RenderSettings settings{};
    /// All lights of the picture; empty: only an environment and emissive surfaces light it. Absent: those of the scene, and
    /// if it has neither lights nor an environment that lights it, the default rig, which is fixed to the camera. For
    /// radiosity, whose solution holds for all views, that is the rig of a default view.
    std::optional<std::vector<Light>> lights{};
    /// The background that is composited after tone mapping: argument `behind` of save() and to_srgb8(). plan_shot() sets it.
    vec4 behind{};
};

/// What the picture of a shot is for.
struct ShotOptions {
    /// Linear light is wanted, not display values. Display values need the background separate where there is an exposure or
    /// a tone curve, so that it keeps its color.
    bool is_linear = false;
    /// One of many views of a scene: the default rig of radiosity is that of a default view, which is solved once.
    bool is_view = false;
    /// decide() leaves adjust_shot() out: for data channels without colors, or where the caller calls it later.
    bool without_adjusting = false;
};

/// Chooses the camera for the scene that a session shows. Empty: choose_camera() by the request.
using CameraOf = std::function<Camera(const Scene& scene)>;

/// Makes the choices that a request leaves open, once for a picture, a document or a sequence: those of its look, the array
/// and the range of its coloring. They are written into the request. The session then shows the scene at its first moment.
/// With Look::standard the session draws a small picture, by which background, exposure and the size of points are chosen.
/// @param loaded  passed validate()
/// @param first   the clips at the first moment
/// @return the shot of that moment
/// @throws Error as Session::show() and choose_camera()
RL_API Shot decide(Session& session, const std::shared_ptr<const Scene>& loaded, PictureRequest& request,
                   std::span<const ClipTime> first, const CameraOf& camera, const ShotOptions& options,
                   Context& context);

/// The shot of a scene that a session shows: the lights and settings of a request, seen through a camera. The report gets
/// notes on lights that a preset leaves out and on ranges that a cutoff sets.
/// @param request  after decide()
/// @throws Error bad_file: an invalid light
RL_API Shot plan_shot(const Scene& shown, const PictureRequest& request, const Camera& camera,
                      const ShotOptions& options, Context& context);

/// The small picture of decide() for a shot of a scene that the session shows.
/// @param shot  gets what is chosen, as the request does
RL_API void adjust_shot(Session& session, Shot& shot, PictureRequest& request, const ShotOptions& options,
                        Context& context);

/// First part of decide(). Chooses settings that neither the file nor the request gives: up axis, samples, light, shadows,
/// and whether the file's camera and lights are used. The report lists decisions about the file.
/// @param scene  as loaded, at the first moment
RL_API void apply_look(const Scene& scene, PictureRequest& request, Context& context);

/// A loaded scene, at its moment, as a request wants it: with its materials, coloring, environment, preset, points and fog.
/// @param request  after apply_look()
/// @throws Error bad_file: an invalid scene (see validate()); usage: no such attribute; not_found, bad_file: a picture of
///         the request
RL_API Scene as_requested(Scene scene, const PictureRequest& request, Context& context);

/// The lights of a picture: the lights of the request, or of the scene, or the default rig. light_intensity and
/// light_cutoff of the request are applied.
/// @param camera  result of choose_camera()
RL_API std::vector<Light> requested_lights(const Scene& scene, const PictureRequest& request, const Camera& camera);

}  // namespace rakelight
