// SPDX-License-Identifier: Apache-2.0
// The command line, read: what to do, with all values checked.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/picture.h>

#include "bench_verb.h"
#include "check_verb.h"
#include "console.h"
#include "explain_verb.h"
#include "inspect_verb.h"
#include "smooth_verb.h"
#include "stages_verb.h"
#include "world_options.h"

namespace rakelight::cli {

enum class Verb { help, version, render, inspect, smooth, bench, explain, stages, check };

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
    bool print_schema = false;
    Loudness loudness = Loudness::normal;
    std::vector<std::string> arguments;  ///< as given, the program's name first
};

/// What is to be done with one input, or why nothing can be.
struct InputRequest {
    PictureRequest picture;
    std::optional<Error> error;
    std::optional<WorldOptions> world;  ///< of a world file
};

/// @throws Error usage, one line
Options parse(int argc, const char* const* argv);

/// The request for an input: as the command line says, and for a world file by its [render], too.
InputRequest request_for(const Options& options, const std::string& input);

/// How `rakelight render` would draw a world. @param arguments  options. @throws Error bad_file, usage
PictureRequest request_of_world(std::vector<std::string> arguments, const std::string& world, bool allow_outside);

/// Reads [render] of a world as `rakelight render` would, and holds it against the loaded scene; nothing for other
/// files. @throws Error bad_file
void check_world_options(const Options& options, const std::string& input, const Scene& scene, Context& context);

/// A request for each input: '{model}' in the output stands for the input's name without folder and ending.
/// @throws Error usage: several inputs for one output, or two inputs for the same
std::vector<InputRequest> picture_requests(const Options& options);

}  // namespace rakelight::cli
