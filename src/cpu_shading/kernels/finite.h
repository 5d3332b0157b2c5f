// SPDX-License-Identifier: Apache-2.0
// What comes out of kernels is finite. Per instruction set.
#pragma once
#include <stdint.h>

#include "math/wide.h"

namespace rakelight::cpu_shading::RL_ISA {
RL_USE_WIDE;

/// What is not finite becomes 0 and is counted, in the first `alive` lanes (1..lanes).
inline real only_finite(real v, int32_t alive, int32_t& not_finite) {
    const mask is_finite = v - v == real(0.0f);
    if (all_lanes(is_finite)) return v;
    not_finite += __builtin_popcount(lane_bits(!is_finite) & ((uint32_t(2) << (alive - 1)) - 1));
    return select(is_finite, v, real(0.0f));
}

}  // namespace rakelight::cpu_shading::RL_ISA
