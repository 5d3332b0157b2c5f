// SPDX-License-Identifier: Apache-2.0
// Input of the fast weld's kernels. Plain structs, because sources compiled per instruction set include this header.
#pragma once
#include <stdint.h>

namespace rakelight::geometry {

/// The hash of a float position; -0 is +0. Equal positions and seeds have equal hashes in every flavor.
constexpr uint32_t hash_multipliers[4] = {0x9e3779b1u, 0x85ebca77u, 0xc2b2ae3du, 0x846ca68bu};

struct WeldKernels {
    /// Hashes of `count` positions.
    /// @param positions  [3 * count]
    /// @param hashes     [count]
    void (*hash)(const float* positions, uint32_t count, uint32_t seed, uint32_t* hashes);
};

namespace scalar {
const WeldKernels* weld_kernels();
}
namespace sse2 {
const WeldKernels* weld_kernels();
}
namespace avx2 {
const WeldKernels* weld_kernels();
}
namespace avx512 {
const WeldKernels* weld_kernels();
}

}  // namespace rakelight::geometry
