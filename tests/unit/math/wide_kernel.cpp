// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set: runs every operation of math/wide.h over arrays.
#include "wide_kernel.h"
#include "math/wide.h"

namespace rakelight::wide_test::RL_ISA {

RL_USE_WIDE;

// Loads the operands of one step; not every operation uses all of them.
#define RL_LOOP(step)                                                                 \
    for (int at = 0; at < in.count; at += lanes) {                                    \
        [[maybe_unused]] const float* pa = in.a + at;                                 \
        [[maybe_unused]] const int32_t* pi = (const int32_t*)(in.a + at);             \
        [[maybe_unused]] const float* block = in.a + at / 32 * 32;                    \
        [[maybe_unused]] const int32_t* integer_block = (const int32_t*)block;        \
        [[maybe_unused]] const uint32_t* unsigned_block = (const uint32_t*)block;     \
        [[maybe_unused]] real a = load(pa), b = load(in.b + at), c = load(in.c + at); \
        [[maybe_unused]] integer i = bits_of(a), j = bits_of(b);                      \
        step;                                                                         \
    }

/// Of the numbers that gather_pairs() and gather_quads() read for each lane, one.
static integer one_of_pair(const uint32_t* base, integer index, int which) {
    integer out[2];
    gather_pairs(base, index, out[0], out[1]);
    return out[which];
}
static integer one_of_quad(const uint32_t* base, integer index, int which) {
    integer out[4];
    gather_quads(base, index, out);
    return out[which];
}

#define RL_REAL(name, result) \
    static void run_##name(const Inputs& in, float* out) { RL_LOOP(store(out + at, result)) }
#define RL_TRUTH(name, result) \
    static void run_##name(const Inputs& in, float* out) { RL_LOOP(store(out + at, select(result, 1.0f, 0.0f))) }
#define RL_INTEGER(name, result) \
    static void run_##name(const Inputs& in, float* out) { RL_LOOP(store((int32_t*)(out + at), result)) }
#include "wide_operations.inc"
#undef RL_REAL
#undef RL_TRUTH
#undef RL_INTEGER

#define RL_REAL(name, result) {#name, true, run_##name},
#define RL_TRUTH(name, result) {#name, false, run_##name},
#define RL_INTEGER(name, result) {#name, false, run_##name},
static const Operation operations[] = {
#include "wide_operations.inc"
};

static void store_positive(const float* x, float* out, int count) {
    for (int at = 0; at < count; at += lanes) store_masked(out + at, load(x + at) + 1.0f, load(x + at) > 0.0f);
}

static void store_positive_integers(const int32_t* x, int32_t* out, int count) {
    for (int at = 0; at < count; at += lanes)
        store_masked(out + at, load_i(x + at) + integer(1), load_i(x + at) > integer(0));
}

static uint32_t vote(const float* x) {
    const mask m = load(x) > 0.0f;
    return (any_lane(m) ? 1u : 0u) | (all_lanes(m) ? 2u : 0u) | (no_lane(m) ? 4u : 0u) | lane_bits(m) << 8;
}

static void take_apart(const float* x, int32_t* indices, float* reals, int32_t* integers, bool* truths) {
    store(indices, lane_indices());
    for (int at = 0; at < lanes; ++at) {
        reals[at] = lane(load(x), at);
        integers[at] = lane(bits_of(load(x)), at);
        truths[at] = lane(load(x) > 0.0f, at);
    }
}

const Kernel kernel = {
    lanes, operations, int(sizeof operations / sizeof operations[0]), store_positive, store_positive_integers,
    vote,  take_apart};

}  // namespace rakelight::wide_test::RL_ISA
