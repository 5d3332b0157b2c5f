// SPDX-License-Identifier: Apache-2.0
// The result of explain().
#pragma once
#include <memory>
#include <string>
#include <vector>

#include <rakelight/tools/explain.h>

#include "engines/raster/inspect/inspection.h"
#include "render/remarks/shader_terms.h"

namespace rakelight {

/// What the default look chose because it was not given.
struct LookChoice {
    std::string topic, value;  ///< "light", "the built-in studio ..."
};

struct ExplainedPixel {
    std::string file;
    std::shared_ptr<const raster::Inspection> engine;  ///< the scene, for names
    std::vector<LookChoice> look;                      ///< in the order of docs/default-look.md; empty: a plain picture
    raster::PixelExplanation pixel;
    std::optional<raster::PixelExplanation> nearest;  ///< if no surface is visible: the nearest pixel where one is
    std::optional<ShadedPixel> shaded;                ///< by shaders of the user's; `pixel` then has their color
    ToneSettings tone;
    vec4 displayed;  ///< linear, with exposure and tone curve, as it is encoded
    std::vector<std::uint8_t> codes;
};

/// What the textbook's depth (0 on the near plane, 1 on the far one) changes by for 1 of the depth key.
double standard_depth_per_key(const ExplainedPixel& e);

/// [m] in the world of a point relative to the eye.
dvec3 world_position(const ExplainedPixel& e, const float (&relative)[3]);

}  // namespace rakelight
