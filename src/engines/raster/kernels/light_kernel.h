// SPDX-License-Identifier: Apache-2.0
// Lighting of points before there are pixels, for flat and Gouraud shading. The light that a point receives is kept
// per unit of reflectance and in three terms, so that textures act per pixel. Ambient occlusion affects only the
// ambient term, metalness and specular maps only the specular one. Per instruction set.
#pragma once
#include "cpu_shading/kernels/light_points.h"
#include "engines/raster/kernels/kernel_types.h"

namespace rakelight::raster::RL_ISA {
RL_USE_WIDE;
namespace cpu = rakelight::cpu_shading::RL_ISA;
namespace lit = rakelight::lighting::RL_ISA;

inline vec3 load3(const float* const (&from)[3], int32_t i) {
    return vec3(load(from[0] + i), load(from[1] + i), load(from[2] + i));
}
inline void store3(float* const (&to)[3], int32_t i, vec3 v) {
    store(to[0] + i, v.x);
    store(to[1] + i, v.y);
    store(to[2] + i, v.z);
}

inline void light_points(const LightJob* job) {
    for (int32_t i = 0; i < job->count; i += lanes) {
        const lit::LightTerms sum = cpu::light_of_point({*job->material}, job->roughness, load3(job->position, i),
                                                        load3(job->position, i), load3(job->normal, i));
        store3(job->ambient, i, sum.ambient);
        store3(job->diffuse, i, sum.diffuse);
        store3(job->specular, i, sum.specular);
    }
}

}  // namespace rakelight::raster::RL_ISA
