// SPDX-License-Identifier: Apache-2.0
// FlushDenormals: denormal floats count as zero in this scope and thread (MXCSR FTZ and DAZ). Denormals cost about
// three times the whole shader (pow(n.h, 48) makes them). Stands at the head of raster bodies, on the calling thread
// too; attributes run without it.
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
