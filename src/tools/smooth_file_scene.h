// SPDX-License-Identifier: Apache-2.0
// The attributes that smooth_file() writes, as a scene.
#pragma once
#include <rakelight/smooth_file.h>

namespace rakelight {

/// New normals for all drawn triangle meshes and tangents by the choice (meshes that are not to have any have none);
/// nodes and the first meshes in the order of `scene`, copies for placements of their own after them.
Scene smooth_for_file(const Scene& scene, const SmoothFileOptions& options, Context& context);

}  // namespace rakelight
