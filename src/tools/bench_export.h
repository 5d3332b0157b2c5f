// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Writes a scene as GLB for other programs to be measured with: pictures that are made by formulas go into it as PNG. What
/// glTF cannot hold (classical materials, lights that do not thin out by the square) is converted and said in the report.
/// @throws Error failed: cannot write
void export_bench_scene(const Scene& scene, const std::string& path, Context& context);

}  // namespace rakelight
