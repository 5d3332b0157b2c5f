// SPDX-License-Identifier: Apache-2.0
// Which instruction set the kernels run: the best that this processor has, or the one that RAKELIGHT_ISA names.
#pragma once

namespace rakelight {

enum class Isa { scalar, sse2, avx2, avx512 };

/// "scalar", "sse2", "avx2", "avx512"
const char* name(Isa isa);

/// Whether processor and operating system have it. avx2 is used without FMA; avx512 means F, BW, DQ, VL and CD.
bool is_available(Isa isa);

/// The widest one that is available.
Isa best_isa();

/// RAKELIGHT_ISA = scalar | sse2 | avx2 | avx512, or best_isa() where it is unset or empty. Reads the environment each
/// time.
/// @throws Error usage: an unknown word, or a set that this processor lacks; never a silent substitute.
Isa isa_from_environment();

}  // namespace rakelight
