// SPDX-License-Identifier: Apache-2.0
// On which side of their triangles normals stand, asked once for all poses.
#pragma once
#include <memory>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/scene.h>

#include "geometry/normal_sides.h"

namespace rakelight {

/// [meshes] of find_normal_sides(), skinned ones in bind pose; meshes whose format says where their fronts are
/// (metallic-roughness materials) are left out. Null: all are.
std::shared_ptr<const std::vector<geometry::NormalSides>> bound_sides(const Scene& scene, Context& context);

}  // namespace rakelight
