// SPDX-License-Identifier: Apache-2.0
// Relief, environment and fog as plain numbers. C headers only: kernels of every instruction set read them.
#pragma once
#include <stdint.h>

namespace rakelight::shading {

/// How a draw's height map acts.
struct ReliefFactors {
    int32_t technique;  ///< ReliefTechnique
    float depth;        ///< [widths of the texture] from height 0 to 1
    float level;        ///< 0..1: the height that lies in the polygon
    int32_t holds_depth, min_steps, max_steps, refinement_steps, self_shadow, limit_silhouette;
    float to_uv[2][2];   ///< rows: change of u and of v for one width along the tangent and along the bitangent
    float to_map[2][2];  ///< the same of the map's own coordinates, behind the slot's transform
};

/// Light from the environment, without its pictures.
struct EnvironmentFactors {
    float irradiance[9][3];  ///< spherical harmonics of irradiance / pi, scaled for the polynomial in x, y, z
    float turn[3][3];        ///< rows: the axes of the environment's picture in the world
    float intensity;
};

/// Where a point about the eye, world axes, lies on the picture of what is behind transmissive surfaces: u w, v w, w of
/// (x, y, z, 1); u, v from its top left corner.
struct BehindFactors {
    float to_u[4], to_v[4], to_w[4];
    float last_level;  ///< of its mip chain, 1 x 1
};

struct FogFactors {
    int32_t kind;  ///< FogNumber
    float color[3], start, end, density;
};

}  // namespace rakelight::shading
