// SPDX-License-Identifier: Apache-2.0
// Single pictures, to any target.
#pragma once
#include <rakelight/render/picture.h>
#include <rakelight/render/session.h>

#include "render/output/picture_target.h"
#include "render/shot.h"

namespace rakelight {

/// Draws a single picture of a loaded scene.
/// @param session  of the engine that is requested
/// @param loaded   passed validate()
/// @param request  gets what is decided
/// @throws Error as render_picture()
PictureResult draw_picture(Session& session, Scene loaded, PictureRequest& request, PictureTarget& target,
                           const ChangeScene& change, Context& context);
/// The same of a scene at its moment: see decide_moment().
PictureResult draw_moment(Scene moment, const PictureRequest& asked, PictureRequest& request, PictureTarget& target,
                          Context& context);

/// render_picture() into memory, with a step between.
PictureResult render_changed(const PictureRequest& request, const ChangeScene& change, std::vector<std::byte>& file,
                             Context& context);

}  // namespace rakelight
