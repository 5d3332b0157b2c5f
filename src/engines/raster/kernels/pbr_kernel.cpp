// SPDX-License-Identifier: Apache-2.0
// The kernels of glTF's own material. Compiled once per instruction set.
#include "engines/raster/kernels/shade_pixels.h"

namespace rakelight::raster::RL_ISA {

int32_t shade_pbr(const ShadeJob* job) {
    if (job->shadows != nullptr) return shade_pixels < cpu::PbrMaterial, lanes < 32 ? 4 : 2, true > (*job);
    return shade_pixels < cpu::PbrMaterial, lanes < 32 ? 4 : 2, false > (*job);
}

int32_t shade_pbr_environment(const ShadeJob* job) {
    if (job->shadows != nullptr) return shade_pixels < cpu::PbrInEnvironment, lanes < 32 ? 4 : 2, true > (*job);
    return shade_pixels < cpu::PbrInEnvironment, lanes < 32 ? 4 : 2, false > (*job);
}

}  // namespace rakelight::raster::RL_ISA
