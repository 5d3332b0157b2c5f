// SPDX-License-Identifier: Apache-2.0
// The verb `bench`: measurements of the program itself.
#pragma once
#include <string>
#include <vector>

#include <rakelight/bench.h>

#include "render_options.h"

namespace CLI {
class App;
}

namespace rakelight::cli {

struct Options;

struct BenchWords {
    std::string what, scene, triangles, objects;
    // bench smooth
    std::string order, crease, tolerance, repetitions, with;
    bool brute_force = false;
    // bench render
    std::string lights, engines, frames, output, export_file;
    RenderWords render;  ///< those of pictures; bench smooth has weight and crease angle of them
};

void add_bench_options(CLI::App& app, BenchWords& words);

/// What `rakelight bench` measures.
struct BenchRequest {
    bool is_render = false;
    SmoothBenchOptions smooth;
    RenderBenchOptions render;
    /// Those of the command line that `rakelight render` has too; a world's [render] has to give way to them.
    std::vector<std::string> picture_arguments;
    bool has_engines = false;  ///< --engine was given
};

/// @throws Error usage: a wrong value, or an option of what is not measured
void apply(const BenchWords& words, BenchRequest& request);

int run_bench(const Options& options);

}  // namespace rakelight::cli
