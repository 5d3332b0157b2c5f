// SPDX-License-Identifier: Apache-2.0
// FlushDenormals: treats denormal floats as zero in this scope and thread, as operands and as results. Denormals, for
// example from pow(n.h, 48), can triple the shading time. Used in every parallel loop body of the rasterizer;
// attributes do not use it. x86-64: FTZ and DAZ of MXCSR. AArch64: FZ of FPCR. It tests a result before rounding, so a
// result in the last half ulp below the smallest normal number becomes zero there, and that number on x86-64. Other
// processors keep their denormals.
#pragma once
#include <cstdint>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace rakelight {

class FlushDenormals {
public:
    FlushDenormals() : before_(control()) { set_control(before_ | flush); }
    ~FlushDenormals() { set_control(before_); }
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

private:
#if defined(__x86_64__)
    using Control = unsigned;
    static constexpr Control flush = 0x8040;  // FTZ, DAZ
    static Control control() { return _mm_getcsr(); }
    static void set_control(Control value) { _mm_setcsr(value); }
#elif defined(__aarch64__)
    using Control = std::uint64_t;
    static constexpr Control flush = std::uint64_t(1) << 24;  // FZ
    static Control control() {
        Control value;
        __asm__ volatile("mrs %0, fpcr" : "=r"(value) : : "memory");
        return value;
    }
    static void set_control(Control value) { __asm__ volatile("msr fpcr, %0" : : "r"(value) : "memory"); }
#else
    using Control = int;
    static constexpr Control flush = 0;
    static Control control() { return 0; }
    static void set_control(Control) {}
#endif
    Control before_;
};

}  // namespace rakelight
