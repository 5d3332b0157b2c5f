// SPDX-License-Identifier: Apache-2.0
// The steps of render_picture(), for interactive programs that reuse results between pictures.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <rakelight/export.h>
#include <rakelight/picture.h>
#include <rakelight/scene_queries.h>
#include <rakelight/session.h>

namespace rakelight {

/// The steps of render_picture() between loading and preparing a scene: clips at their times, apply_look(), colors of
/// vertex arrays, with_requested_surfaces(), and points as the look draws them. The request is explicit in the settings
/// that these steps chose.
/// @throws Error bad_file: see validate(); usage: no such clip or array; not_found: a picture of the request
RL_API Scene with_requested_look(Scene scene, PictureRequest& request, Context& context);

/// apply_look_exposure() with a session that already has the scene, so that nothing is prepared twice.
/// @param shot  camera of choose_camera() and lights; the settings are those of the request
RL_API void apply_look_exposure(Session& session, const Shot& shot, PictureRequest& request, Context& context);

/// First step of Look::standard. Chooses settings that neither the file nor the request gives: samples, light, shadows,
/// and whether the file's camera and lights are used. Writes the chosen settings into the request. The report lists
/// decisions about the file.
/// @param scene  as loaded
RL_API void apply_look(const Scene& scene, PictureRequest& request, Context& context);

/// Second step of Look::standard, for settings that depend on the prepared scene: the brightness of the background, and
/// the exposure of photometric lights.
/// @param prepared  result of with_requested_surfaces()
RL_API void apply_look_exposure(const Scene& prepared, PictureRequest& request, Context& context);

/// A loaded scene with the materials and the environment of a request. Each call creates new textures for the picture
/// files of the request. So call this function again only if PictureRequest::materials or a member hdri_* changed.
/// @throws Error bad_file: an invalid scene (see validate()); not_found, bad_file: a picture of the request
RL_API Scene with_requested_surfaces(Scene scene, const PictureRequest& request, Context& context);

/// Prepares settings for pictures in display values. With an exposure or a tone curve, the background must be
/// composited after tone mapping, so that it keeps its display color. The settings then render without the background.
/// @return the background to composite: argument `behind` of save() and to_srgb8()
RL_API vec4 separate_background(RenderSettings& settings, const ToneSettings& tone);

/// The lights of a picture: the lights of the request, or of the scene, or the default rig. light_intensity and
/// light_cutoff of the request are applied.
/// @param camera  result of choose_camera()
RL_API std::vector<Light> requested_lights(const Scene& scene, const PictureRequest& request, const Camera& camera);

/// Shot::lights for such a picture in a session that draws many views: requested_lights(), or absent for radiosity by the
/// default rig, which a session solves once for all views.
RL_API std::optional<std::vector<Light>> shot_lights(const Scene& scene, const PictureRequest& request,
                                                     const Camera& camera);

}  // namespace rakelight
