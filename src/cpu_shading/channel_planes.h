// SPDX-License-Identifier: Apache-2.0
// Where kernels write data channels. C headers only: read by kernels of every instruction set.
#pragma once
#include <stdint.h>

namespace rakelight::cpu_shading {

/// Arrays of ChannelValues: the first of each channel's components.
enum ChannelPlaneNumber : int32_t {
    plane_position = 0,
    plane_barycentric = 3,
    plane_uv = 6,
    plane_uv1 = 8,
    plane_tangent = 10,
    plane_base_color = 14,
    plane_ambient = 17,
    plane_diffuse = 20,
    plane_specular = 23,
    plane_emission = 26,
    channel_planes = 29,
};

/// Data of the points of a job beside their color.
struct ChannelValues {
    int32_t needs_terms;         ///< one of ambient, diffuse, specular and emission is wanted
    float* out[channel_planes];  ///< [count] each; null: not wanted. Positions are about the eye
};

}  // namespace rakelight::cpu_shading
