// SPDX-License-Identifier: Apache-2.0
// FlushDenormals: treats denormal floats as zero in this scope and thread (MXCSR FTZ and DAZ). Denormals, for example
// from pow(n.h, 48), can triple the shading time. Used in every parallel loop body of the rasterizer; attributes do not
// use it.
#pragma once
#include <xmmintrin.h>

namespace rakelight {

class FlushDenormals {
public:
    FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | flush_to_zero | denormals_are_zero); }
    ~FlushDenormals() { _mm_setcsr(before_); }
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

private:
    static constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
    unsigned before_;
};

}  // namespace rakelight
