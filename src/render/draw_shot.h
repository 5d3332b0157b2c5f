// SPDX-License-Identifier: Apache-2.0
// From a shot to a finished picture.
#pragma once
#include <rakelight/render/picture.h>
#include <rakelight/render/session.h>

#include "render/output/picture_target.h"

namespace rakelight {

/// Draws a shot of the scene that a session shows, with the overlays of a request. A cancelled picture is kept if the request
/// says so.
/// @param target  without channels that only overlays need
/// @param range   the scales of data channels, and the box that the grid lies below; null: of the scene
/// @param result  gets counts, times, statistics and the names of channel files
/// @throws Error as Session::render() and of the target
void draw_shot(Session& session, Shot shot, const PictureRequest& request, PictureTarget& target,
               const ChannelRange* range, PictureResult& result, Context& context);

}  // namespace rakelight
