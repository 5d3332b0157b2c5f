// SPDX-License-Identifier: Apache-2.0
// Options about how surfaces answer light: lighting models, bumps, shadows. All are keys of [render].
#pragma once
#include <string>
#include <vector>

#include <rakelight/world.h>

namespace CLI {
class App;
}

namespace rakelight::cli {

/// The words as given; empty where not given.
struct SurfaceWords {
    std::string lighting, specular, specular_horizon, ward_form, multiple_scattering, viewer_infinity;
    std::string bump, bump_terms, depth, bias, polarity, steps, refinement, self_shadow, silhouette;
    std::string tangent_space, normalize_frames;
    std::string shadows, shadow_size, shadow_bias, shadow_filter;
};

/// Declares the options with their help. `words` must live until the command line is read.
/// @param group  of all of them in the help; null: each its own
void add_surface_options(CLI::App& app, SurfaceWords& words, const char* group = nullptr);

/// What was given, by keys of [render].
void add_values(const SurfaceWords& words, std::vector<WorldValue>& values);

}  // namespace rakelight::cli
