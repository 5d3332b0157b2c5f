// SPDX-License-Identifier: Apache-2.0
// Indices of refraction of bodies, by the color of the light.
#pragma once
#include <algorithm>

#include "shading/material_factors.h"

namespace rakelight::shading {

/// Index of refraction for the equations: 0 is the extension's word for a perfect mirror.
inline float refraction_of(const MaterialFactors& m) {
    return m.refraction > 0 ? std::clamp(m.refraction, 0.01f, 1e4f) : 1e4f;
}

/// Of light of one color, 0 to 2: red, green, blue; < 0: of all. KHR_materials_dispersion: Cauchy's formula by the index for 587.6 nm
/// and the Abbe number, at the dominant wavelengths of the display's primaries.
inline float refraction_of(const MaterialFactors& m, int color) {
    const float mean = refraction_of(m);
    if (color < 0 || !(m.dispersion > 0) || !(m.refraction > 0)) return mean;
    constexpr float nanometers[] = {611.4f, 549.1f, 464.2f};
    const float wave = nanometers[color];
    return std::clamp(mean + (mean - 1) * m.dispersion * (1.0f / 20) * (523655.0f / (wave * wave) - 1.5168f), 1.0f,
                      1e4f);
}

}  // namespace rakelight::shading
