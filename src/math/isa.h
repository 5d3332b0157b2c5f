// SPDX-License-Identifier: Apache-2.0
// Selection of the kernels' instruction set: the best of this processor, or RAKELIGHT_ISA.
#pragma once

namespace rakelight {

enum class Isa { scalar, sse2, avx2, avx512 };

/// RL_BY_ISA(isa, kernels()) is avx2::kernels() for Isa::avx2, and so on: the same expression in the namespace of each
/// instruction set. WebAssembly has the SSE2 kernels alone, other
/// processors the scalar ones.
#if defined(__x86_64__)
#define RL_BY_ISA(isa, expression)                      \
    ([](::rakelight::Isa set) {                         \
        using ::rakelight::Isa;                         \
        return set == Isa::avx512 ? avx512::expression  \
               : set == Isa::avx2 ? avx2::expression    \
               : set == Isa::sse2 ? sse2::expression    \
                                  : scalar::expression; \
    }(isa))
#elif defined(__EMSCRIPTEN__)
#define RL_BY_ISA(isa, expression) ([](::rakelight::Isa) { return sse2::expression; }(isa))
#else
#define RL_BY_ISA(isa, expression) ([](::rakelight::Isa) { return scalar::expression; }(isa))
#endif

/// The namespace of the kernels that every machine of this build can run.
#if defined(__EMSCRIPTEN__)
#define RL_COMMON_ISA sse2
#else
#define RL_COMMON_ISA scalar
#endif

/// "scalar", "sse2", "avx2", "avx512"
const char* name(Isa isa);

/// Whether processor and operating system support it. avx2 is used without FMA; avx512 means F, BW, DQ, VL and CD.
bool is_available(Isa isa);

/// The widest available one.
Isa best_isa();

/// RAKELIGHT_ISA = scalar | sse2 | avx2 | avx512, or best_isa() if unset or empty. Reads the environment at each call.
/// @throws Error usage: an unknown word, or an unsupported set; there is no silent fallback.
Isa isa_from_environment();

}  // namespace rakelight
