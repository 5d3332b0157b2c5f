// SPDX-License-Identifier: Apache-2.0
// SIMD types of `lanes` floats, integers and masks, with the same vocabulary in every flavor (scalar: plain float).
// Only sources compiled per instruction set (rl_add_isa_sources) include this; only these files name xsimd.
//
// A kernel is in `namespace rakelight::<module>::RL_ISA` and imports the names with `RL_USE_WIDE` (a using-directive
// would conflict with rakelight::vec3 and rakelight::min of other headers). Reading order: wide_scalar.h or
// wide_xsimd.h (types and native operations), wide_functions.h (exp2, log2, pow_positive, rounding), wide_vector.h
// (vec2, vec3, vec4).
//
// Guarantee: every function is bit-identical in every flavor, lane by lane (tests/unit/math/wide_test.cpp). So min(a,
// b) is a < b ? a : b and max(a, b) is a > b ? a : b: if a or b is NaN, or both are zero, the result is b; clamp(x, lo,
// hi) is min(max(x, lo), hi): NaN gives lo; to_int truncates; out of range and NaN give INT32_MIN; floor, ceil, trunc
// keep the sign of zero; / and sqrt round correctly, nothing is approximate, nothing is fused; integer + - * must not
// overflow (the scalar flavour is plain int32_t); gathers read every lane: make the index of dead lanes 0 with select()
// first.
#pragma once
#include <stddef.h>
#include <stdint.h>

#if !defined(RL_ISA)
#error "math/wide.h belongs in sources that are compiled per instruction set: rl_add_isa_sources()"
#endif

// The namespace of one native vector: all lanes, or half of them with RL_WIDE_PAIRS.
#if defined(RL_WIDE_PAIRS)
#define RL_WIDE_PART RL_ISA::half
#else
#define RL_WIDE_PART RL_ISA
#endif
#if defined(RL_ISA_scalar)
#include "math/wide_scalar.h"
#else
#include "math/wide_xsimd.h"
#endif
#if defined(RL_WIDE_PAIRS)
#include "math/wide_pair.h"
#endif
#include "math/wide_functions.h"
#include "math/wide_vector.h"

/// Imports the vocabulary into the kernel's namespace.
#define RL_USE_WIDE                                                                                                 \
    using rakelight::wide::RL_ISA::real, rakelight::wide::RL_ISA::integer, rakelight::wide::RL_ISA::mask;           \
    using rakelight::wide::RL_ISA::vec2, rakelight::wide::RL_ISA::vec3, rakelight::wide::RL_ISA::vec4;              \
    using rakelight::wide::RL_ISA::lanes, rakelight::wide::RL_ISA::lane_indices, rakelight::wide::RL_ISA::lane;     \
    using rakelight::wide::RL_ISA::load, rakelight::wide::RL_ISA::load_i, rakelight::wide::RL_ISA::store;           \
    using rakelight::wide::RL_ISA::load_masked, rakelight::wide::RL_ISA::load_i_masked;                             \
    using rakelight::wide::RL_ISA::store_masked, rakelight::wide::RL_ISA::store_compressed;                         \
    using rakelight::wide::RL_ISA::broadcast, rakelight::wide::RL_ISA::broadcast_i;                                 \
    using rakelight::wide::RL_ISA::gather, rakelight::wide::RL_ISA::gather_i;                                       \
    using rakelight::wide::RL_ISA::to_int, rakelight::wide::RL_ISA::to_int_floor, rakelight::wide::RL_ISA::to_real; \
    using rakelight::wide::RL_ISA::bits_of, rakelight::wide::RL_ISA::real_from_bits;                                \
    using rakelight::wide::RL_ISA::shift_right_logical;                                                             \
    using rakelight::wide::RL_ISA::select, rakelight::wide::RL_ISA::any_lane, rakelight::wide::RL_ISA::all_lanes;   \
    using rakelight::wide::RL_ISA::no_lane, rakelight::wide::RL_ISA::lane_bits;                                     \
    using rakelight::wide::RL_ISA::min, rakelight::wide::RL_ISA::max, rakelight::wide::RL_ISA::clamp;               \
    using rakelight::wide::RL_ISA::abs, rakelight::wide::RL_ISA::sqrt, rakelight::wide::RL_ISA::floor;              \
    using rakelight::wide::RL_ISA::ceil, rakelight::wide::RL_ISA::trunc, rakelight::wide::RL_ISA::fract;            \
    using rakelight::wide::RL_ISA::reciprocal, rakelight::wide::RL_ISA::copy_sign, rakelight::wide::RL_ISA::mix;    \
    using rakelight::wide::RL_ISA::exp2, rakelight::wide::RL_ISA::exp, rakelight::wide::RL_ISA::log2;               \
    using rakelight::wide::RL_ISA::log2_coarse;                                                                     \
    using rakelight::wide::RL_ISA::pow_positive, rakelight::wide::RL_ISA::safe_sqrt;                                \
    using rakelight::wide::RL_ISA::add16, rakelight::wide::RL_ISA::sub16;                                           \
    using rakelight::wide::RL_ISA::scale16, rakelight::wide::RL_ISA::low_in_both_halves;                            \
    using rakelight::wide::RL_ISA::gather_pairs;                                                                    \
    using rakelight::wide::RL_ISA::gather_quads, rakelight::wide::RL_ISA::look_up;                                  \
    using rakelight::wide::RL_ISA::dot, rakelight::wide::RL_ISA::cross, rakelight::wide::RL_ISA::length;            \
    using rakelight::wide::RL_ISA::normalize, rakelight::wide::RL_ISA::safe_normalize;                              \
    using rakelight::wide::RL_ISA::safe_normalize_or
