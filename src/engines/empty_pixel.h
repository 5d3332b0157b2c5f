// SPDX-License-Identifier: Apache-2.0
// The initial color of pixels, and the background that is laid behind the finished picture.
#pragma once
#include <rakelight/engines/engine.h>

namespace rakelight {

/// The color of a pixel that nothing covers if no environment is shown: the background, or without alpha if that is
/// laid behind later.
inline vec4 empty_pixel(const RenderSettings& settings) {
    const vec4 b = settings.background;
    return {b.x, b.y, b.z, settings.composites_background ? b.w : 0};
}

/// The background as glass and mirrors see it.
inline vec3 light_of_background(const RenderSettings& settings) {
    return settings.background_light.value_or(settings.background.xyz());
}

/// What is laid behind the finished picture.
inline vec4 laid_behind(const RenderSettings& settings) {
    return settings.composites_background ? vec4{} : settings.background;
}

}  // namespace rakelight
