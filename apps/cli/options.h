// SPDX-License-Identifier: Apache-2.0
// The command line, read: what to do, with all values checked.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/picture.h>

#include "bench_verb.h"
#include "console.h"
#include "explain_verb.h"
#include "inspect_verb.h"
#include "smooth_verb.h"
#include "stages_verb.h"

namespace rakelight::cli {

enum class Verb { help, version, render, inspect, smooth, bench, explain, stages };

struct Options {
    Verb verb = Verb::help;
    std::string help;  ///< text for Verb::help
    std::vector<std::string> inputs;
    PictureRequest picture;  ///< output holds the name template
    InspectRequest inspect;
    SmoothFileOptions smooth;
    BenchRequest bench;
    ExplainRequest explain;
    int threads = 0;
    std::uint64_t max_memory = 0;
    bool json = false;
    bool stats = false;  ///< render says what it counted
    Loudness loudness = Loudness::normal;
};

/// @throws Error usage, one line
Options parse(int argc, const char* const* argv);

/// A request for each input: '{model}' in the output stands for the input's name without folder and ending.
/// @throws Error usage: several inputs for one output, or two inputs for the same
std::vector<PictureRequest> picture_requests(const Options& options);

}  // namespace rakelight::cli
