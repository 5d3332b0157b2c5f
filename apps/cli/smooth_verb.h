// SPDX-License-Identifier: Apache-2.0
// `rakelight smooth`: its options, and the verb itself.
#pragma once
#include <string>

#include <rakelight/smooth_file.h>

namespace CLI {
class App;
}

namespace rakelight::cli {

struct Options;

/// The words as given; empty where not given.
struct SmoothWords {
    std::string output, scope, crease_angle, weight, weld_distance, tangents;
    bool keep_instances = false;
};

/// Declares the options with their help. `words` must live until the command line is read.
void add_smooth_options(CLI::App& app, SmoothWords& words);

/// @throws Error usage
void apply(const SmoothWords& words, SmoothFileOptions& options);

/// Smooths each input to its output; returns the exit code.
int run_smooth(const Options& options);

}  // namespace rakelight::cli
