// SPDX-License-Identifier: Apache-2.0
// Input of the skinning kernel. Plain structs, because sources compiled per instruction set include this header.
#pragma once
#include <stdint.h>

namespace rakelight::geometry {

constexpr uint32_t joint_floats = 16;  ///< of a joint's matrix: four columns of four, the last of each unused
/// Directions with squared lengths outside of this range are left to the caller, because of under- or overflow.
constexpr float min_square = 1e-30f, greatest_square = 1e30f;

/// Influences of a vertex, as rakelight::JointInfluence.
struct KernelInfluence {
    uint16_t joints[4];
    float weights[4];
};

/// A range of vertices.
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
