// SPDX-License-Identifier: Apache-2.0
// Input of the kernel of face votes. Plain structs, because sources compiled per instruction set include this header.
#pragma once
#include <stdint.h>

namespace rakelight::geometry {

constexpr uint32_t vote_block = 64;  ///< faces at a time

/// The votes of the faces of a block for their corners, in structure-of-arrays layout.
struct VoteBlock {
    enum Number { normal_x, normal_y, normal_z, weight, tangent_x, tangent_y, tangent_z, hand, numbers };
    alignas(64) double votes[3][numbers][vote_block];  ///< [corner][number][face] unit normal and tangent times weight
    uint8_t is_odd[vote_block];  ///< left to the caller: no area, or squares that may under- or overflow
};

/// Corner weights, as rakelight::CornerWeight.
enum class VoteWeight : uint32_t { uniform, area, angle, angle_area, max };

/// Some faces of one mesh, at most a block. All arithmetic in double, in the order of face_vote.h: the same bits.
struct VoteJob {
    const float* positions = nullptr;   ///< [3 * vertices]
    const float* texcoords = nullptr;   ///< [2 * vertices], or null: no tangents
    const uint32_t* indices = nullptr;  ///< [3 * count]
    uint32_t count = 0;
    VoteWeight weight = VoteWeight::angle;
    double linear[3][3] = {}, normal_to_world[3][3] = {};  ///< columns
    double flip = 1;
};

struct VoteKernels {
    void (*vote)(const VoteJob& job, VoteBlock& out);
};

namespace scalar {
const VoteKernels* vote_kernels();
}
namespace sse2 {
const VoteKernels* vote_kernels();
}
namespace avx2 {
const VoteKernels* vote_kernels();
}
namespace avx512 {
const VoteKernels* vote_kernels();
}

}  // namespace rakelight::geometry
