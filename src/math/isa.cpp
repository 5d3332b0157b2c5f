// SPDX-License-Identifier: Apache-2.0
#include "math/isa.h"

#include <cstdlib>
#include <string>

#include <rakelight/base/error.h>

namespace rakelight {

namespace {
constexpr Isa all_isas[] = {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512};
}

const char* name(Isa isa) {
    constexpr const char* names[] = {"scalar", "sse2", "avx2", "avx512"};
    return names[static_cast<int>(isa)];
}

#if defined(__x86_64__)
bool is_available(Isa isa) {
    // The builtins use CPUID and XGETBV, so they also check that the operating system saves the wide registers.
    switch (isa) {
        case Isa::scalar:
            return true;
        case Isa::sse2:
            return __builtin_cpu_supports("sse2");
        case Isa::avx2:
            return __builtin_cpu_supports("avx2");
        case Isa::avx512:
            return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                   __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
                   __builtin_cpu_supports("avx512cd");
    }
    return false;
}
#elif defined(__EMSCRIPTEN__)
bool is_available(Isa isa) { return isa == Isa::sse2; }
#else
bool is_available(Isa isa) { return isa == Isa::scalar; }
#endif

Isa best_isa() {
    Isa best = Isa::scalar;
    for (const Isa isa : all_isas)
        if (is_available(isa)) best = isa;
    return best;
}

Isa isa_from_environment() {
    const char* word = std::getenv("RAKELIGHT_ISA");
    if (word == nullptr || *word == '\0') return best_isa();
    for (const Isa isa : all_isas) {
        if (std::string(word) != name(isa)) continue;
        if (is_available(isa)) return isa;
        throw Error(ErrorCode::usage, std::string("this processor has no ") + name(isa), "RAKELIGHT_ISA",
                    std::string("the best it has is ") + name(best_isa()));
    }
    throw Error(ErrorCode::usage, "unknown instruction set '" + one_line(word, 40) + "'", "RAKELIGHT_ISA",
                "use scalar, sse2, avx2 or avx512");
}

}  // namespace rakelight
