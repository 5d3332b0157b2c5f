// SPDX-License-Identifier: Apache-2.0
// The environment's picture behind everything. Per instruction set.
#pragma once
#include "cpu_shading/kernels/light_around.h"
#include "engines/raster/kernels/store.h"

namespace rakelight::raster::RL_ISA {
namespace cpu = rakelight::cpu_shading::RL_ISA;
namespace lit = rakelight::lighting::RL_ISA;

inline void sky(const SkyJob* job) {
    const cpu::Maps maps = {nullptr, real(0.0f), real(0.0f), job->environment, nullptr, nullptr};
    const lit::Environment environment = cpu::environment_of(*job->environment);
    const real height(float(job->environment->sky->height[0]));
    for (int32_t i = 0; i < job->count; i += lanes) {
        const integer pixel = load_i(job->pixel + i);
        const real x = to_real(pixel & integer(tile_size - 1)), y = to_real(shift_right_logical(pixel, tile_bits));
        const auto component = [&](int c) {
            return real(job->ray[c][0]) * x + real(job->ray[c][1]) * y + real(job->ray[c][2]);
        };
        const vec3 ray(component(0), component(1), component(2));
        const real scale = reciprocal(sqrt(max(dot(ray, ray), real(1e-20f))));
        const vec3 color = lit::sky_color(maps, environment, ray * scale, real(job->pixel_size) * scale, height);
        if (job->display.srgb8 != nullptr) {
            store_display(job->display, job->pixel + i, job->count - i, color);
            continue;
        }
        store(job->red + i, color.x);
        store(job->green + i, color.y);
        store(job->blue + i, color.z);
    }
}

}  // namespace rakelight::raster::RL_ISA
