// SPDX-License-Identifier: Apache-2.0
// The kernels of classical materials and of glTF's own, and the table of all kernels. Compiled once per instruction set.
#include "engines/raytrace/kernels/shade_hits.h"

namespace rakelight::raytrace::RL_ISA {

int32_t shade_classical(const HitJob& job) { return shade_hits<cpu::ClassicalMaterial, 1>(job); }
int32_t shade_pbr(const HitJob& job) { return shade_hits<cpu::PbrMaterial, 1>(job); }
int32_t shade_pbr_environment(const HitJob& job) { return shade_hits<cpu::PbrInEnvironment, 1>(job); }

static int32_t shade(const HitJob* job) {
    switch (job->kernel) {
        case cpu_shading::kernel_classical:
            return shade_classical(*job);
        case cpu_shading::kernel_pbr:
            return shade_pbr(*job);
        case cpu_shading::kernel_pbr_environment:
            return shade_pbr_environment(*job);
        default:
            return shade_every(*job);
    }
}

static void sky(const SkyJob* job) {
    const cpu::Maps maps = {nullptr, real(0.0f), real(0.0f), job->environment, nullptr, nullptr};
    const lit::Environment environment = cpu::environment_of(*job->environment);
    const real height(float(job->environment->sky->height[0]));
    for (int32_t i = 0; i < job->count; i += lanes) {
        const auto vector = [&](int32_t plane) {
            const auto at = [&](int32_t c) {
                return load(job->rays.planes + int64_t(plane + c) * job->rays.capacity + i);
            };
            return vec3(at(0), at(1), at(2));
        };
        const vec3 ray = vector(ray_d), change = vector(ray_d_dy);
        const real scale = reciprocal(sqrt(max(dot(ray, ray), real(1e-20f))));
        const real size = job->orthographic != 0 ? real(0.0f) : sqrt(dot(change, change)) * scale;
        const vec3 color = lit::sky_color(maps, environment, ray * scale, size, height);
        store(job->red + i, color.x);
        store(job->green + i, color.y);
        store(job->blue + i, color.z);
    }
}

void alpha(const HitJob* job);  // every_kernel.cpp
void through(const HitJob* job);
void channels(const ChannelJob* job);
int32_t walk(const PathJob* job);  // path_kernel.cpp
void emission(const HitJob* job);

const Kernels* kernels() {
    static constexpr Kernels table = {lanes, shade, alpha, through, channels, walk, emission, sky};
    return &table;
}

}  // namespace rakelight::raytrace::RL_ISA
