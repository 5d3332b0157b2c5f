// SPDX-License-Identifier: Apache-2.0
// What a material of any lighting model is at a run of pixels. Per instruction set.
#pragma once
#include "engines/raster/kernels/surface.h"

namespace rakelight::raster::RL_ISA {

/// All of a surface but its directions.
inline void set_material(const ShadeJob& job, const Pixels& p, const BaseColor& base, lit::MaterialSurface& s) {
    set_reflectance(job, p, base, s.base);
}

}  // namespace rakelight::raster::RL_ISA
