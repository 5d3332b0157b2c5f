// SPDX-License-Identifier: Apache-2.0
// `rakelight check`: whether scene files load, and what they hold.
#pragma once
#include <rakelight/check_scene.h>

namespace CLI {
class App;
}

namespace rakelight::cli {

struct Options;

struct CheckWords {
    bool schema = false;
};

void add_check_options(CLI::App& app, CheckWords& words);

/// Loads each input and says what it holds; returns the exit code.
int run_check(const Options& options);

}  // namespace rakelight::cli
