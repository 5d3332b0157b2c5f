// SPDX-License-Identifier: Apache-2.0
// Baselines for the speed of attributes.
#pragma once
#include <span>

#include "tools/bench/bench_model.h"

namespace rakelight {

/// The plain loop: one thread, objects separately (so with seams), unit face normals summed per vertex and normalized.
/// @param out  [parts] normals only
void plain_loop(const BenchModel& model, std::span<const AttributeBuffers> out);

/// The publication's way: for every vertex, all faces of all objects, by equal positions. One thread, O(n^2).
void brute_force(const BenchModel& model, std::span<const AttributeBuffers> out, const Context& context);

/// [GB/s] of memcpy on all threads, bytes read plus bytes written; the best of five.
double copy_bandwidth(Context& context);

}  // namespace rakelight
