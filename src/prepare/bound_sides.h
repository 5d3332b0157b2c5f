// SPDX-License-Identifier: Apache-2.0
// The sides of triangles on which normals lie, found once for all poses.
#pragma once
#include <memory>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "geometry/faults/normal_sides.h"

namespace rakelight {

/// [meshes] results of find_normal_sides(), skinned meshes in bind pose. Meshes whose format defines front faces
/// (metallic-roughness materials) are skipped. Null: all are skipped.
std::shared_ptr<const std::vector<geometry::NormalSides>> bound_sides(const Scene& scene, Context& context);

}  // namespace rakelight
