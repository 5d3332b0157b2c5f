// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Writes a scene as GLB for other programs to be measured with: pictures that are made by formulas go into it as PNG. What
/// glTF cannot hold (classical materials, lights without inverse-square attenuation) is converted and reported.
/// @throws Error failed: cannot write
void export_bench_scene(const Scene& scene, const std::string& path, Context& context);

}  // namespace rakelight
