// SPDX-License-Identifier: Apache-2.0
// `rakelight inspect`: its options, and the verb itself.
#pragma once
#include <optional>
#include <string>

#include <rakelight/inspect.h>

#include "render_options.h"

namespace CLI {
class App;
}

namespace rakelight::cli {

struct Options;

/// The words as given; empty where not given.
struct InspectWords {
    bool no_borders = false, no_surfaces = false;
    bool check = false, no_degenerate = false, no_t_junctions = false, no_non_manifold = false,
         consistent_winding = false, no_inside_out = false, closed = false, unit_normals = false;
    std::string max_seam, weld_distance, heat_map;
    RenderWords render;  ///< normals, and how the heat map is seen
};

/// What `rakelight inspect` is to do beside looking.
struct InspectRequest {
    InspectOptions options;
    std::optional<CheckLimits> check;
};

/// Declares the options with their help. `words` must live until the command line is read.
void add_inspect_options(CLI::App& app, InspectWords& words);

/// The heat map's view, size and name go to `picture`. @throws Error usage
void apply(const InspectWords& words, InspectRequest& request, PictureRequest& picture);

/// Inspects each input; returns the exit code.
int run_inspect(const Options& options);

}  // namespace rakelight::cli
