// SPDX-License-Identifier: Apache-2.0
// Height and normal maps in the full kernel: where a ray into the relief meets it, the frame that is lit, and the
// shadows that heights throw on each other. Per instruction set.
#pragma once
#include "engines/raster/kernels/surface.h"

namespace rakelight::raster::RL_ISA {

/// Texture coordinates where the ray meets the relief.
inline void find_relief_texcoords(const ShadeJob& job, Pixels& p) { find_texcoords(*job.material, p); }

/// Normals, tangent and direction to the viewer.
inline void set_frame(const ShadeJob& job, const Pixels& p, lit::MaterialSurface& s) {
    s.base.n = s.diffuse_n = shading_normal(job, p);
    s.base.v = to_viewer(job, p.position);
}

/// Light i as the pixel meets it, in the space of the surface's frame.
inline lit::LightSample sample_in_frame(const ShadeJob& job, int32_t i, const Pixels& p, const lit::MaterialSurface&) {
    return lit::sample_light(job.lights[i], p.position);
}

/// 0..1: how much of the light passes the relief.
inline real relief_shadow(const ShadeJob&, const Pixels&, const lit::MaterialSurface&, const lit::LightSample&) {
    return real(1.0f);
}

}  // namespace rakelight::raster::RL_ISA
