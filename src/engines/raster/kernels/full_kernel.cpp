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

static void widen(real low, real high, float& to_low, float& to_high) {
    float of[2][lanes];
    store(of[0], low);
    store(of[1], high);
    to_low = of[0][0], to_high = of[1][0];
    for (int32_t i = 1; i < lanes; ++i) {
        to_low = of[0][i] < to_low ? of[0][i] : to_low;
        to_high = of[1][i] > to_high ? of[1][i] : to_high;
    }
}

void bounds(const ShadeJob* job, LightBox* box) {
    vec3 low = vec3(real(3.40282347e38f)), high = vec3(real(-3.40282347e38f));
    for (int32_t i = 0; i < job->count; i += lanes) {
        const vec3 p = Pixels(*job, i).position;
        low = vec3(min(p.x, low.x), min(p.y, low.y), min(p.z, low.z));
        high = vec3(max(p.x, high.x), max(p.y, high.y), max(p.z, high.z));
    }
    widen(low.x, high.x, box->low[0], box->high[0]);
    widen(low.y, high.y, box->low[1], box->high[1]);
    widen(low.z, high.z, box->low[2], box->high[2]);
}

void light_full(const LightJob* job) {
    const ShadeJob& shade = *job->shade;
    for (int32_t i = 0; i < job->count; i += lanes) {
        const vec3 position = load3(job->position, i);
        const lit::MaterialSurface s = full_point(shade, job->roughness, position, load3(job->normal, i));
        lit::LightTerms sum = lit::no_terms();
        for (int32_t k = 0; k < shade.light_count; ++k)
            sum = lit::both_terms(sum, point_terms(shade, s, lit::sample_light(shade.lights[k], position)));
        store_terms(*job, i, sum);
    }
}

}  // namespace rakelight::raster::RL_ISA
