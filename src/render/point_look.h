// SPDX-License-Identifier: Apache-2.0
// The default look of points: sized by their spacing, and lit if they have normals.
#pragma once
#include <rakelight/render/session.h>

#include <rakelight/world/request.h>

namespace rakelight {

/// Draws points with normals as small pieces of surface, unless a way to draw points is given.
Scene with_splats(Scene scene, const PictureRequest& request, Context& context);

/// Sets the size [px] of the points that are left, likewise: so that a surface that they lie in closes.
/// @param session  shows the scene of the shot
void size_points(PictureRequest& request, Session& session, const Shot& shot, Context& context);

}  // namespace rakelight
