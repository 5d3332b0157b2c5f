// SPDX-License-Identifier: Apache-2.0
// A scene's environment decoded, before an engine packs it as it samples it.
#pragma once
#include <functional>

#include <rakelight/scene.h>

#include "image/environment.h"

namespace rakelight::shading {

/// The picture of all around with its mip levels, and what is prefiltered of it.
struct EnvironmentImages {
    MipChain sky;
    EnvironmentLight light;
};

/// Whether a picture shows the environment, or is lit by it.
bool uses_environment(const Scene& scene);

/// Decodes the environment of a scene that uses one and hands it to `pack`. What either of them throws for a picture
/// becomes a warning in the report.
void load_environment(const Scene& scene, const std::function<void(const EnvironmentImages&)>& pack, Context& context);

}  // namespace rakelight::shading
