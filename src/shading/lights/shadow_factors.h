// SPDX-License-Identifier: Apache-2.0
// A shadow map as plain numbers, without its texels. C headers only: kernels of every instruction set read them.
#pragma once
#include <stdint.h>

namespace rakelight::shading {

/// One light's shadow map, row 0 on top, of how near to the light the nearest surface is. Parallel: minus the distance
/// along the way it shines; else 1 / the distance along the axis of the map, 0: nothing. Linear over the map for a
/// plane.
struct ShadowFactors {
    int32_t size, faces;  ///< [texels] of a side; 1, or 6 about +x, -x, +y, -y, +z, -z of the world
    int32_t is_orthographic;
    float to_light[3]
                  [4];  ///< rows: position about the eye -> x to the right, y up, z ahead of the map, about the light
    float texels;       ///< a meter (perspective: a meter at a distance of one) has
    float bias;         ///< of the half texel that surfaces are pushed out by
    int32_t filter;     ///< [texels] radius
};

inline constexpr float nothing_on_parallel_map = -3e38f;  ///< nearness where nothing is; else 0
/// Change of nearness along x (low 16 bits) and down y (high ones) of a map per width of a texel, as
/// (slope + steepest_slope_on_map) * slope_codes.
inline constexpr float steepest_slope_on_map = 8, slope_codes = 4095;

}  // namespace rakelight::shading
