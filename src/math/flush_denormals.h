// SPDX-License-Identifier: Apache-2.0
// FlushDenormals: in this scope and thread, denormal floats count as zero, as operands and as results. Denormals cost
// about three times the whole shader (pow(n.h, 48) makes them). Stands at the head of raster bodies, on the calling
// thread too; attributes run without it. x86-64: MXCSR's FTZ and DAZ. AArch64: FPCR's FZ, which looks at a result
// before it is rounded: one in the last half ulp below the least normal number becomes zero there, and that number on
// x86-64. Other processors keep their denormals.
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
        __asm__ volatile("mrs %0, fpcr" : "=r"(value));
        return value;
    }
    static void set_control(Control value) { __asm__ volatile("msr fpcr, %0" : : "r"(value)); }
#else
    using Control = int;
    static constexpr Control flush = 0;
    static Control control() { return 0; }
    static void set_control(Control) {}
#endif
    Control before_;
};

}  // namespace rakelight
