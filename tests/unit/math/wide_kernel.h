// SPDX-License-Identifier: Apache-2.0
// What one flavour of the test kernel offers. `count` is a multiple of 32; blocks hold 32 elements.
#pragma once
#include <stdint.h>

namespace rakelight::wide_test {

struct Inputs {
    const float *a, *b, *c;
    int count;
};

struct Operation {
    const char* name;
    bool is_real;  ///< results are floats, whose NaNs are all alike; else integers
    void (*run)(const Inputs& in, float* out);
};

struct Kernel {
    int lanes;
    const Operation* operations;
    int operation_count;
    /// Stores x[i] + 1 only where x[i] > 0.
    void (*store_positive)(const float* x, float* out, int count);
    void (*store_positive_integers)(const int32_t* x, int32_t* out, int count);
    /// Of the lanes' x > 0: bit 0 any_lane, bit 1 all_lanes, bit 2 no_lane, from bit 8 on lane_bits.
    uint32_t (*vote)(const float* x);
    /// lane_indices(), and lane() of each lane of x, i, x > 0.
    void (*take_apart)(const float* x, int32_t* indices, float* reals, int32_t* integers, bool* truths);
};

namespace scalar {
extern const Kernel kernel;
}
namespace sse2 {
extern const Kernel kernel;
}
namespace avx2 {
extern const Kernel kernel;
}
namespace avx512 {
extern const Kernel kernel;
}
namespace avx512x2 {  // pairs of vectors: math/wide_pair.h
extern const Kernel kernel;
}

}  // namespace rakelight::wide_test
