// SPDX-License-Identifier: Apache-2.0
// What the kernel of skinning is given. Plain structs: this header is seen by sources compiled per instruction set.
#pragma once
#include <stdint.h>

namespace rakelight::geometry {

constexpr uint32_t joint_floats = 16;  ///< of a joint's matrix: four columns of four, the last of each unused
/// Squared lengths of directions outside of these are left to the caller: they may have under- or overflown.
constexpr float min_square = 1e-30f, greatest_square = 1e30f;

/// Of a vertex, as rakelight::JointInfluence.
struct KernelInfluence {
    uint16_t joints[4];
    float weights[4];
};

/// Some vertices one after another.
struct SkinJob {
    const float* joints = nullptr;                                            ///< [joint_floats * joints]
    const KernelInfluence *influences = nullptr, *more_influences = nullptr;  ///< [count]; the second may be null
    const float *positions = nullptr, *normals = nullptr,
                *tangents = nullptr;  ///< [3], [3], [4 * count]; the last two may be null
    float *out_positions = nullptr, *out_normals = nullptr, *out_tangents = nullptr;
    uint32_t count = 0;
    uint32_t* odd = nullptr;  ///< [count] vertices whose directions are left to the caller
    uint32_t odd_count = 0;
};

struct SkinKernels {
    void (*skin)(SkinJob& job);
};

namespace scalar {
const SkinKernels* skin_kernels();
}
namespace sse2 {
const SkinKernels* skin_kernels();
}
namespace avx2 {
const SkinKernels* skin_kernels();
}
namespace avx512 {
const SkinKernels* skin_kernels();
}

}  // namespace rakelight::geometry
