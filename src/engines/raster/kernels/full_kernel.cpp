// SPDX-License-Identifier: Apache-2.0
// The entries of the full kernel and of the data channels. Compiled once per instruction set.
#include "engines/raster/kernels/full_kernel.h"

#include "engines/raster/kernels/channel_kernel.h"
#include "engines/raster/kernels/store.h"

namespace rakelight::raster::RL_ISA {

int32_t shade_full(const ShadeJob* job) {
    int32_t not_finite = 0;
    for (int32_t i = 0; i < job->count; i += lanes) {
        FullPixels f;
        find_full(*job, i, f);
        not_finite += store_finite(*job, i, full_radiance(*job, f), shown_alpha(*job, f.bumps, f.base.color.w));
        if (job->normal_x != nullptr) store_normal(*job, i, f.surface.base.n);
    }
    return not_finite;
}

void alpha_full(const ShadeJob* job) {
    for (int32_t i = 0; i < job->count; i += lanes) {
        Pixels p(*job, i);
        Bumps bumps;
        find_relief_texcoords(*job, p, bumps);
        store(job->alpha + i, shown_alpha(*job, bumps, base_color(*job->material, p).color.w));
    }
}

void channels(const ChannelJob* job) { find_channels(*job); }

}  // namespace rakelight::raster::RL_ISA
