// SPDX-License-Identifier: Apache-2.0
// The steps of render_picture() as they were before shot.h, for programs that still use them.
#pragma once
#include <optional>
#include <vector>

#include <rakelight/picture.h>
#include <rakelight/session.h>
#include <rakelight/shot.h>

namespace rakelight {

/// The first part of decide(), and the scene that Session::show() draws.
RL_API Scene with_requested_look(Scene scene, PictureRequest& request, Context& context);
/// adjust_shot(), of a session that has the scene, and of a scene alone.
RL_API void apply_look_exposure(Session& session, const Shot& shot, PictureRequest& request, Context& context);
RL_API void apply_look_exposure(const Scene& requested, PictureRequest& request, Context& context);
/// A scene with the materials, the coloring, the environment and the preset of a request.
RL_API Scene with_requested_surfaces(Scene scene, const PictureRequest& request, Context& context);
/// As plan_shot() does it. @return Shot::behind
RL_API vec4 separate_background(RenderSettings& settings, const ToneSettings& tone);
/// Shot::lights of plan_shot() for one of many views.
RL_API std::optional<std::vector<Light>> shot_lights(const Scene& scene, const PictureRequest& request,
                                                     const Camera& camera);

}  // namespace rakelight
