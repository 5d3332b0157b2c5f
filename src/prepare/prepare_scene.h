// SPDX-License-Identifier: Apache-2.0
// Scene -> scene, before an engine sees it: texture coordinates, normals and tangents. Untouched blocks are shared.
#pragma once
#include <optional>
#include <vector>

#include <rakelight/geometry/attributes.h>
#include <rakelight/prepare/prepare.h>
#include <rakelight/scene/scene.h>

#include "prepare/generated_attributes.h"
#include "prepare/normals/repair_borders.h"
#include "prepare/pose_scene.h"

namespace rakelight {

/// Public functions for validated scenes, without validate().
namespace valid {
Scene prepare_scene(Scene scene, const PrepareOptions& options, Context& context);
}

/// A prepared scene before posing, with the normals and tangents of the bind pose.
struct BoundScene {
    Scene scene;                              ///< without Scene::pose
    std::vector<GeneratedAttributes> made{};  ///< to be recomputed for animated meshes
    std::vector<BoundBorders> borders{};      ///< to be joined again afterwards; `scene` has the normals before
};
/// Whether to prepare a scene in two halves: it is animated, and the first half does not depend on the pose. (It does
/// for animated control nets and clockwise triangles.)
bool has_bind_pose(const Scene& scene, const PrepareOptions& options);
/// The first half of prepare_scene(). @param scene  passed validate(), has a bind pose
BoundScene bind_scene(Scene scene, const PrepareOptions& options, Context& context);
/// The second half, for any pose: vertices, displacement, missing tangents.
/// @param pose pose of the nodes; absent: none
Scene finish_scene(BoundScene bound, const Rare<ScenePose>& pose, const PrepareOptions& options, Context& context);
/// The same, but meshes whose vertices are not needed here stay in bind pose.
UnposedScene finish_unposed(BoundScene bound, const Rare<ScenePose>& pose, const PrepareOptions& options,
                            Context& context);

/// @throws Error usage: a number out of range, an invalid enumerator
void check_options(const PrepareOptions& options);

}  // namespace rakelight
