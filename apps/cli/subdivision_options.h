// SPDX-License-Identifier: Apache-2.0
// Options about subdivision surfaces.
#pragma once
#include <string>

#include <rakelight/scene.h>

namespace CLI {
class App;
}

namespace rakelight::cli {

/// The words as given; empty where not given.
struct SubdivisionWords {
    std::string level, edge, scheme, crease, sharpness, boundary, uv;
};

/// Declares the options with their help. `words` must live until the command line is read.
void add_subdivision_options(CLI::App& app, SubdivisionWords& words);

/// @throws Error usage
void apply(const SubdivisionWords& words, Subdivision& subdivision);

}  // namespace rakelight::cli
