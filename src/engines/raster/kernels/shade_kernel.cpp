// SPDX-License-Identifier: Apache-2.0
// The kernel of classical materials, and the table of all kernels. Compiled once per instruction set: includes only plain
// data, math/wide.h and what stands on it.
#include "engines/raster/kernels/shade_pixels.h"
#include "engines/raster/kernels/sky_kernel.h"

namespace rakelight::raster::RL_ISA {

int32_t shade_classical(const ShadeJob* job) {
    return shade_pixels < cpu::ClassicalMaterial, lanes < 32 ? 4 : 2, false > (*job);
}

static int32_t shade(const ShadeJob* job) {
    switch (job->kernel) {
        case kernel_classical:
            return shade_classical(job);
        case kernel_pbr:
            return shade_pbr(job);
        case kernel_pbr_environment:
            return shade_pbr_environment(job);
        default:
            return shade_every(job);
    }
}

void alpha(const ShadeJob* job);  // every_kernel.cpp
void light(const LightJob* job);
void channels(const ChannelJob* job);
void bounds(const ShadeJob* job, LightBox* box);

const Kernels* kernels() {
    static constexpr Kernels table = {lanes, shade, alpha, light, channels, bounds, sky};
    return &table;
}

}  // namespace rakelight::raster::RL_ISA
