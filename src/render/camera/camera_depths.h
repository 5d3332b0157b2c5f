// SPDX-License-Identifier: Apache-2.0
// Near and far planes of cameras, and whether anything lies between them.
#pragma once
#include <functional>

#include <rakelight/base/report.h>
#include <rakelight/render/picture.h>
#include <rakelight/scene/scene_queries.h>

#include "scene/near_surfaces.h"

namespace rakelight {

/// [m] along the view axis to the nearest surface in the picture of a perspective camera; the limit if none is nearer.
using NearestSurface = std::function<double(const Camera& camera, double limit)>;

/// Half the width and height of the picture: [m] of parallel cameras, else at a distance of 1 m.
dvec2 half_extents(const Camera& camera, double aspect);

/// False if the box is entirely outside one plane of the camera's frustum: nothing of it is visible.
bool may_see(const Camera& camera, double aspect, const Bounds& bounds);

/// Why nothing of the box is visible, without a full stop; empty: something may be.
std::string why_blind(const Camera& camera, double aspect, const Bounds& bounds);
/// Warns of a camera that was requested and sees nothing.
void warn_if_blind(const Camera& camera, double aspect, const Bounds& bounds, const std::string& file, Report& report);

/// Near and far as the request says, where it does. @throws Error usage: near is not less than far
void set_asked_depths(Camera& camera, const ViewRequest& view);

/// Whether near and far of a camera of the file are only defaults: of a perspective one in a world file that gives neither.
bool has_default_depths(const Scene& scene, const Camera& camera);

/// Whether a near plane close to the eye costs a z-buffer its precision. At a distance d one step of a textbook's depth of b bits
/// is d^2 / (near 2^b) m, of its float (which lies between 1/2 and 1) d^2 / (near 2^24) m; of the reversed float it is d / 2^24 m,
/// whatever near is.
bool loses_by_near(Visibility visibility);

/// Nothing is near to a z-buffer that would lose by it. @param surfaces  must stay
NearestSurface nearest_of(const NearSurfaces& surfaces, double aspect, Visibility visibility);

}  // namespace rakelight
