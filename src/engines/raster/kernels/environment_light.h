// SPDX-License-Identifier: Apache-2.0
// Light from all around at a run of pixels. Per instruction set.
#pragma once
#include "engines/raster/kernels/surface.h"

namespace rakelight::raster::RL_ISA {

inline lit::LightTerms environment_terms(const ShadeJob&, const lit::MaterialSurface&) {
    lit::LightTerms terms;
    terms.ambient = terms.diffuse = terms.specular = vec3(real(0.0f));
    return terms;
}

}  // namespace rakelight::raster::RL_ISA
