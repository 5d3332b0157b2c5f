// SPDX-License-Identifier: Apache-2.0
// The maps of a job as the lighting text reads them (lighting/maps.glsl is the same for GLSL). Per instruction set.
#pragma once
#include "cpu_shading/kernels/sample.h"
#include "lighting/read_albedos.h"

namespace rakelight::cpu_shading::RL_ISA {

struct Maps {
    const TextureView* height;
    real height_scale, height_offset;  ///< lit::HeightSense
    const EnvironmentView* environment;
    const lighting::AlbedoTables* tables;
    const TextureView* behind;
};

/// Those of a job, without its heights.
inline Maps maps_of(const MaterialJob& job) {
    return {nullptr,         real(0.0f),  real(0.0f),
            job.environment, &job.albedo, job.behind != nullptr ? job.behind->picture : nullptr};
}

/// Inline, so that channels which nobody reads cost nothing.
[[gnu::always_inline]] inline vec4 sample_level(const TextureView& t, vec2 uv, real level) {
    TexCoords at;
    at.uv = uv;
    return sample(t, footprint_of(t, at, level, true));
}

/// Always filtered linearly: a relief has no steps that its map's texels do not have. Not by sample_level(), whose other
/// three channels the compiler then does not drop: a march takes 4 % longer.
inline real sample_height(const Maps& maps, vec2 uv, real level) {
    TexCoords at;
    at.uv = uv;
    const Footprint f = footprint_of(*maps.height, at, level, true);
    const real height =
        maps.height->rgba32f != nullptr ? filtered(FloatHeights{maps.height->rgba32f}, f) : sample(*maps.height, f).x;
    return maps.height_offset + maps.height_scale * height;
}

inline vec3 sample_environment(const Maps& maps, vec2 uv, real level) {
    return rgb(sample_level(*maps.environment->specular, uv, level));
}

inline vec3 sample_behind(const Maps& maps, vec2 uv, real level) { return rgb(sample_level(*maps.behind, uv, level)); }

inline vec3 sample_sky(const Maps& maps, vec2 uv, real level) {
    return rgb(sample_level(*maps.environment->sky, uv, level));
}

inline real sample_albedo(const Maps& maps, int table, real x, real y) {
    return lit::read_albedo(*maps.tables, table, x, y);
}

}  // namespace rakelight::cpu_shading::RL_ISA
