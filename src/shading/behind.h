// SPDX-License-Identifier: Apache-2.0
// The picture of what is behind transmissive surfaces (lighting/material/transmission.glsl): who needs one, what is on it, from where.
#pragma once
#include <rakelight/engines/engine.h>

#include "shading/draw_list.h"
#include "shading/effect_factors.h"
#include "shading/picture_camera.h"

namespace rakelight::shading {

/// Whether a draw shows what is behind it: a transmissive material that is lit by pbr.
bool shows_behind(const DrawList& list, const Draw& draw, const RenderSettings& settings);
/// Whether some draw does.
bool needs_behind(const DrawList& list, const RenderSettings& settings);
/// Whether the picture of what is behind has a draw: opaque and masked ones that are not transmissive.
bool is_behind(const DrawList& list, const Draw& draw, const RenderSettings& settings);

/// The whole view, whatever the window. Its sides are the powers of two next to the picture's, 2048 at most. So the
/// smaller versions lie exactly, and windows of a picture have the bits of the whole.
PictureCamera camera_behind(const PictureCamera& view);
/// What the picture is drawn with: colors alone, of the surfaces and the scene's own lines and points, over an opaque background.
RenderSettings settings_behind(const RenderSettings& settings, const PictureCamera& behind);
BehindFactors behind_factors(const PictureCamera& behind);

/// Lengths in the world over those of the draw's mesh: the mean of its axes.
float thickness_scale(const Draw& draw);

}  // namespace rakelight::shading
