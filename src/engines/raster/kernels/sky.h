// SPDX-License-Identifier: Apache-2.0
// The environment's picture behind everything. Per instruction set.
#pragma once
#include "engines/raster/kernels/environment_light.h"

namespace rakelight::raster::RL_ISA {

/// Angle of (x, y) from +X, -pi..pi, y = 0 and x = 0 give 0. Error under 1e-7: Abramowitz & Stegun 1964, 4.4.49, for
/// the ratio of the smaller to the larger.
inline real angle_of(real y, real x) {
    const real ax = abs(x), ay = abs(y);
    const real t = min(ax, ay) / max(max(ax, ay), real(1e-20f)), s = t * t;
    real sum(0.0028662257f);
    sum = sum * s - real(0.0161657367f);
    sum = sum * s + real(0.0429096138f);
    sum = sum * s - real(0.0752896400f);
    sum = sum * s + real(0.1065626393f);
    sum = sum * s - real(0.1420889944f);
    sum = sum * s + real(0.1999355085f);
    sum = sum * s - real(0.3333314528f);
    const real small = t + t * s * sum;
    const real half_pi(1.57079633f), whole_pi(3.14159265f);
    const real steep = select(ay > ax, half_pi - small, small);
    return copy_sign(select(x < real(0.0f), whole_pi - steep, steep), y);
}

inline vec3 sky_color(const SkyJob& job, vec3 ray, real pixel_angle) {
    const EnvironmentView& e = *job.environment;
    const TextureView& t = *e.sky;
    const vec3 d = to_environment(e, ray);
    TexCoords c;
    c.uv = vec2(real(0.5f) + angle_of(d.x, -d.z) * real(0.159154943f),
                angle_of(safe_sqrt(d.x * d.x + d.z * d.z), d.y) * real(0.318309886f));
    const real texels =
        pixel_angle * real(float(t.height[0]) * 0.318309886f);  // along v, where they are nowhere squeezed
    return rgb(sample(t, footprint_of(t, c, log2_coarse(texels), true))) * real(e.intensity);
}

inline void sky(const SkyJob* job) {
    for (int32_t i = 0; i < job->count; i += lanes) {
        const integer pixel = load_i(job->pixel + i);
        const real x = to_real(pixel & integer(tile_size - 1)), y = to_real(shift_right_logical(pixel, tile_bits));
        const auto component = [&](int c) {
            return real(job->ray[c][0]) * x + real(job->ray[c][1]) * y + real(job->ray[c][2]);
        };
        const vec3 ray(component(0), component(1), component(2));
        const real scale = reciprocal(sqrt(max(dot(ray, ray), real(1e-20f))));
        const vec3 color = sky_color(*job, ray * scale, real(job->pixel_size) * scale);
        store(job->red + i, color.x);
        store(job->green + i, color.y);
        store(job->blue + i, color.z);
    }
}

}  // namespace rakelight::raster::RL_ISA
