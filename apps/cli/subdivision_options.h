// SPDX-License-Identifier: Apache-2.0
// Options about subdivision surfaces.
#pragma once
#include <string>
#include <vector>

#include <rakelight/world.h>

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

/// What was given, by keys of [render].
void add_values(const SubdivisionWords& words, std::vector<WorldValue>& values);

}  // namespace rakelight::cli
