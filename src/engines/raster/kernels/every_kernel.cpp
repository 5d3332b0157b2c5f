// SPDX-License-Identifier: Apache-2.0
// The kernel of all that a job can ask for, and the entries that no speed depends on. Compiled once per instruction set.
#include "cpu_shading/kernels/channels.h"
#include "engines/raster/kernels/light_kernel.h"
#include "engines/raster/kernels/whole_pixels.h"

namespace rakelight::raster::RL_ISA {

int32_t shade_every(const ShadeJob* job) { return shade_pixels<cpu::EveryMaterial, 1, true>(*job); }

void alpha(const ShadeJob* job) {
    const cpu::Job<cpu::EveryMaterial> material{*job};
    for (int32_t i = 0; i < job->count; i += lanes) {
        PixelSource<1> source(*job, i);
        cpu::Points<cpu::EveryMaterial, 1> b;
        b.count = 1;
        cpu::find_places(material, source, b);
        const real alpha = cpu::find_base_color(material, source, 0, b.of[0].point).color.w;
        store(job->alpha + i, cpu::alpha_in_silhouette(material, b.of[0].bumps, alpha));
    }
}

void light(const LightJob* job) { light_points(job); }

void channels(const ChannelJob* job) { cpu::find_channels<WholePixels, PixelSource<1>>(*job->shade, *job); }

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
        const vec3 p = Pixels().find(*job, i);
        low = vec3(min(p.x, low.x), min(p.y, low.y), min(p.z, low.z));
        high = vec3(max(p.x, high.x), max(p.y, high.y), max(p.z, high.z));
    }
    widen(low.x, high.x, box->low[0], box->high[0]);
    widen(low.y, high.y, box->low[1], box->high[1]);
    widen(low.z, high.z, box->low[2], box->high[2]);
}

}  // namespace rakelight::raster::RL_ISA
