// SPDX-License-Identifier: Apache-2.0
// `rakelight stages`: its options, and the verb itself.
#pragma once
#include <rakelight/stages.h>

#include "render_options.h"

namespace CLI {
class App;
}

namespace rakelight::cli {

struct Options;

/// Declares the options with their help. `words` must live until the command line is read.
void add_stages_options(CLI::App& app, RenderWords& words);

/// Writes the stages of each input; returns the exit code.
int run_stages(const Options& options);

}  // namespace rakelight::cli
