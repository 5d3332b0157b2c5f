// SPDX-License-Identifier: Apache-2.0
// Textures as kernels sample them. C headers only: read by kernels of every instruction set.
#pragma once
#include <stdint.h>

#include "shading/material_factors.h"

namespace rakelight::cpu_shading {

inline constexpr int max_mip_levels = 16;  ///< 32768 texels per side

/// How texture coordinates wrap, and which mip levels are read: the numbers of Wrap and MipFilter (textures.cpp).
enum WrapNumber : int32_t { wrap_repeat, wrap_mirrored, wrap_clamped };
enum MipNumber : int32_t { mip_none, mip_nearest, mip_linear };

/// One texture as the kernel reads it: all levels in one array, row 0 on top. Around each level stands a border of one
/// texel that repeats its edges as the wrap modes say, so that a filter's four texels are always neighbors.
struct TextureView {
    const uint32_t* rgba8;           ///< linear codes of 8 bits, R in the low byte; or null
    const uint32_t* rgba16;          ///< linear codes of 15 bits, two words a texel: R | B << 16, G | A << 16; or null
    const float* rgba32f;            ///< four linear floats per texel; or null
    int32_t levels;                  ///< 1..max_mip_levels
    int32_t origin[max_mip_levels];  ///< [texels] place of each level's texel 0, 0
    int32_t width[max_mip_levels], height[max_mip_levels];            ///< [texels] of each level
    int32_t stride[max_mip_levels];                                   ///< [texels] from row to row: width + 2
    float fixed_width[max_mip_levels], fixed_height[max_mip_levels];  ///< [2^-15 texels] of each level
    int32_t wrap_u, wrap_v;                                           ///< WrapNumber
    int32_t magnify_linear, minify_linear;
    int32_t mip;  ///< MipNumber
};

/// Use of a texture: view (null: none), coordinate set, and the affine transform of u, v.
struct TextureSlot : shading::UvTransform {
    const TextureView* view;
    int32_t texcoord_set;    ///< 0 or 1
    int32_t is_transformed;  ///< 0: the matrix is the identity
};

}  // namespace rakelight::cpu_shading
