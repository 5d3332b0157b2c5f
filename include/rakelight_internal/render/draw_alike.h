// SPDX-License-Identifier: Apache-2.0
// Pictures of two scenes that differ only where the scenes do.
#pragma once
#include <utility>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>
#include <rakelight/image/image.h>
#include <rakelight/world/request.h>

namespace rakelight {

/// Draws two scenes into memory, for a comparison. Both get one look, one camera and one exposure, which are chosen for
/// both scenes together. Settings that a request gives apply to its scene (PictureRequest::given_keys).
/// - The camera is the first of scene a, else the first of scene b, else a fitted one that shows both.
/// - If only one scene is of an STL file, which has Z up, it is turned to Y up; PLY, OFF and lists of points beside it
///   are drawn with Z up instead.
/// - If only one scene has lights or an environment, these light the other scene too.
/// - The look is plain if one of the requests has the plain look.
/// The output and the data channels of the requests are ignored.
/// @return the pictures of a and b, as render_picture() draws them
/// @throws Error as render_picture()
RL_API std::pair<Pixels, Pixels> draw_alike(PictureRequest a, PictureRequest b, Context& context);

}  // namespace rakelight
