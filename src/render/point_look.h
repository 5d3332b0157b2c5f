// SPDX-License-Identifier: Apache-2.0
// The default look of points: as large as their spacing asks for, and lit where they have normals.
#pragma once
#include <rakelight/session.h>

#include <rakelight/request.h>

namespace rakelight {

/// Points with normals as small pieces of surface, where nobody has named how points are drawn.
Scene with_splats(Scene scene, const PictureRequest& request, Context& context);

/// Sets the size [px] of the points that are left, likewise: so that a surface that they lie in closes.
/// @param session  has the scene of the picture
void size_points(PictureRequest& request, Session& session, const Camera& camera, Context& context);

}  // namespace rakelight
