// SPDX-License-Identifier: Apache-2.0
// A picture by paths, pass by pass, until it is good enough.
#pragma once

#include "cpu_shading/scratch_pool.h"
#include "engines/raytrace/paths/path_tile.h"

namespace rakelight::raytrace {

/// The settings as paths use them: without the parts of lighting that are not physical.
RenderSettings path_settings(RenderSettings settings);

/// Follows paths until samples, time or noise say so, and delivers each pass; sinks of strips get the last one alone. After a cancel
/// these get what is there.
/// @return passes, samples and noise are set, the rest is counted in the pool
/// @throws Error failed: cancelled
RayStats render_paths(const PathPicture& picture, const Window& window, Sink& sink, Context& context,
                      cpu_shading::ScratchPool<PathScratch>& pool);

}  // namespace rakelight::raytrace
