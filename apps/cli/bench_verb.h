// SPDX-License-Identifier: Apache-2.0
// The verb `bench`: measurements of the program itself.
#pragma once
#include <string>

#include <rakelight/bench.h>

namespace CLI {
class App;
}

namespace rakelight::cli {

struct Options;

struct BenchWords {
    std::string what, triangles, objects, order, weight, crease_angle, tolerance, repetitions, with;
    bool brute_force = false;
};

void add_bench_options(CLI::App& app, BenchWords& words);

/// @throws Error usage
void apply(const BenchWords& words, SmoothBenchOptions& options);

int run_bench(const Options& options);

}  // namespace rakelight::cli
