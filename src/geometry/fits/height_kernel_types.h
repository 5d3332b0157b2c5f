// SPDX-License-Identifier: Apache-2.0
// Input of the kernel of fitted heights. Plain structs, because sources compiled per instruction set include this header.
#pragma once
#include <stdint.h>

namespace rakelight::geometry {

constexpr uint32_t height_lanes = 8;  ///< places at a time

/// Several places and their neighbors, in structure-of-arrays layout.
struct HeightJob {
    const double* neighbors = nullptr;    ///< [rows][3][height_lanes] from the place; beyond `count` anything
    uint32_t rows = 0;                    ///< the largest count
    uint32_t count[height_lanes] = {};    ///< 0: no place
    double normal[3][height_lanes] = {};  ///< unit, to which the heights are measured
    double scale[height_lanes] = {};      ///< of the neighbors, to about an edge
};

/// A lane of each array is one place. See HeightFit.
struct HeightNumbers {
    double normal[3][height_lanes];
    double residual[height_lanes], bent[height_lanes], certainty[height_lanes];
};
struct HeightResult {
    HeightNumbers cubic, quadric;
    double weight[height_lanes];
};

/// All arithmetic in double and in one order: the same bits for every instruction set.
struct HeightKernels {
    void (*fit)(const HeightJob& job, HeightResult& out);
    void (*wide)(const HeightJob& job, HeightNumbers& out, double (&weight)[height_lanes]);
};

namespace scalar {
const HeightKernels* height_kernels();
}
namespace sse2 {
const HeightKernels* height_kernels();
}
namespace avx2 {
const HeightKernels* height_kernels();
}
namespace avx512 {
const HeightKernels* height_kernels();
}

}  // namespace rakelight::geometry
