// SPDX-License-Identifier: Apache-2.0
// The loop over a job's pixels: stages of cpu_shading/kernels/shade_points.h, compiled for some of all materials. Per
// instruction set.
#pragma once
#include "engines/raster/kernels/pixels.h"
#include "engines/raster/kernels/shadow.h"
#include "engines/raster/kernels/store.h"

namespace rakelight::raster::RL_ISA {

/// What light reaches a vector of pixels, by shadow maps.
template <class Kind, int32_t most>
struct SeenByMaps {
    const ShadeJob& job;
    const PixelSource<most>& source;
    const cpu::Points<Kind, most>& points;

    real operator()(int32_t k, int32_t i, const lit::LightSample&) const {
        return shadow_factor(job, i, source.pixels[k], points.of[k].point.position);
    }
};

inline int32_t vectors_from(const ShadeJob& job, int32_t first, int32_t most) {
    const int32_t vectors = (job.count - first + lanes - 1) / lanes;
    return vectors < most ? vectors : most;
}

template <class Kind, int32_t most>
inline int32_t store_pixels(const ShadeJob& job, int32_t first, const cpu::Points<Kind, most>& b,
                            vec3 (&radiance)[most]) {
    const cpu::Job<Kind> material{job};
    int32_t not_finite = 0;
    for (int32_t k = 0; k < b.count; ++k) {
        const int32_t at = first + k * lanes;
        const vec3 color = cpu::behind_fog(material, b.of[k].point.position, radiance[k]);
        not_finite += store_finite(job, at, color, cpu::alpha_of(material, b.of[k]));
        if (job.normal_x != nullptr) store_normal(job, at, cpu::base_of(b.of[k].surface).n);
    }
    return not_finite;
}

/// `most` vectors at a time. @return how many components came out not finite
template <class Kind, int32_t most, bool has_shadows>
inline int32_t shade_pixels(const ShadeJob& job) {
    const cpu::Job<Kind> material{job};
    const cpu::Wanted wanted = {(job.lit == nullptr && job.unlit == 0) || job.normal_x != nullptr,
                                job.display.srgb8 == nullptr};  // sRGB codes are opaque
    int32_t not_finite = 0;
    cpu::Points<Kind, most> b;
    vec3 radiance[most];
    for (int32_t i = 0; i < job.count; i += lanes * most) {
        PixelSource<most> source(job, i);
        b.count = vectors_from(job, i, most);
        cpu::find_surfaces(material, source, wanted, b);
        if constexpr (has_shadows)
            cpu::find_radiance(material, source, b, SeenByMaps<Kind, most>{job, source, b}, radiance);
        else
            cpu::find_radiance(material, source, b, cpu::AllSeen{}, radiance);
        not_finite += store_pixels(job, i, b, radiance);
    }
    return not_finite;
}

// One for each KernelNumber.
int32_t shade_classical(const ShadeJob* job);
int32_t shade_pbr(const ShadeJob* job);
int32_t shade_pbr_environment(const ShadeJob* job);
int32_t shade_every(const ShadeJob* job);

}  // namespace rakelight::raster::RL_ISA
