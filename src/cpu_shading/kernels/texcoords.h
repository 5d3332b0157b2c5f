// SPDX-License-Identifier: Apache-2.0
// The words of the kernels, and texture coordinates. Per instruction set.
#pragma once
#include "cpu_shading/material_job.h"
#include "lighting/lighting.h"

namespace rakelight::cpu_shading::RL_ISA {
RL_USE_WIDE;
namespace lit = rakelight::lighting::RL_ISA;

/// Texture coordinates with their change from pixel to pixel.
struct TexCoords {
    vec2 uv, dx, dy;
};

inline vec3 splat(const float (&v)[3]) { return vec3(real(v[0]), real(v[1]), real(v[2])); }
inline vec3 rgb(vec4 v) { return vec3(v.x, v.y, v.z); }

}  // namespace rakelight::cpu_shading::RL_ISA
