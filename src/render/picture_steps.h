// SPDX-License-Identifier: Apache-2.0
// The steps of render_picture(), also for tests that use their own session.
#pragma once
#include <rakelight/picture.h>
#include <rakelight/radiosity.h>
#include <rakelight/session.h>

#include "world/scene_of_request.h"

namespace rakelight {

/// What a picture is drawn from.
struct ReadyScene {
    std::shared_ptr<PreparedScene> prepared;
    Camera camera;
    std::vector<Light> lights;
    /// Without settings.
    Shot shot() const { return {camera, {}, lights}; }
};
/// Chooses the camera, sets the lights and prepares; lights it by radiosity where that is the method.
/// @param scene  of scene_of_request()
/// @param report  out: what came of radiosity; null: not wanted
/// @throws Error bad_file: nothing to draw
ReadyScene ready_scene(Scene scene, const PictureRequest& request, Context& context, RadiosityReport* report = nullptr);

/// Draws a scene into memory. @param loaded  as_requested()
/// @return the request with what its look has chosen
PictureRequest draw_to_pixels(Scene loaded, const PictureRequest& request, Pixels& color, Context& context);

/// Counts of what is drawn.
void count_parts(const Scene& prepared, PictureResult& result);

/// Draws the scene of a session and writes the files, in bands.
/// @param shot  without settings: they are the request's
void draw_to_files(Session& session, const Shot& shot, const PictureRequest& request, PictureResult& result,
                   Context& context);

/// Everything but the choice of the engine and the checks.
PictureResult draw_picture(const PictureRequest& request, Session& session, Context& context);
/// @param loaded  as_requested()
PictureResult draw_picture(Scene loaded, const PictureRequest& request, Session& session, Context& context);

}  // namespace rakelight
