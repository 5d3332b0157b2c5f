// SPDX-License-Identifier: Apache-2.0
#include <rakelight/picture_parts.h>

#include <rakelight/linear.h>
#include <rakelight/validate.h>

#include "engines/empty_pixel.h"
#include "image/tone_curves.h"
#include "render/picture_steps.h"

namespace rakelight {

Scene with_requested_surfaces(Scene scene, const PictureRequest& request, Context& context) {
    validate(scene);
    return as_requested(std::move(scene), request, context);
}

vec4 separate_background(RenderSettings& settings, const ToneSettings& tone) {
    const bool changes_colors = tone.mapping != ToneMapping::none || tone.exposure_ev != 0;
    if (!changes_colors || !(settings.background.w > 0)) return {};
    settings.composites_background = false;
    settings.background_light = ToneCurve(tone).light_for(settings.background.xyz());
    return laid_behind(settings);
}

}  // namespace rakelight
