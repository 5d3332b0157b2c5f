// SPDX-License-Identifier: Apache-2.0
// `rakelight explain`: its options, and the verb itself.
#pragma once
#include <string>

#include <rakelight/explain.h>

#include "render_options.h"

namespace CLI {
class App;
}

namespace rakelight::cli {

struct Options;

/// The words as given; empty where not given.
struct ExplainWords {
    RenderWords render;
    std::string pixel;
};

/// Which pixel.
struct ExplainRequest {
    int x = 0, y = 0;
};

/// Declares the options with their help. `words` must live until the command line is read.
void add_explain_options(CLI::App& app, ExplainWords& words);

/// @throws Error usage: also a pixel that is not in the picture
void apply(const ExplainWords& words, ExplainRequest& request, PictureRequest& picture);

/// Explains a pixel of each input; returns the exit code.
int run_explain(const Options& options);

}  // namespace rakelight::cli
