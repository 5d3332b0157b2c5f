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

/// Texture coordinates by projection about the world bounding box, for triangle meshes of a valid scene that have none;
/// reported.
Scene project_texcoords(Scene scene, UvProjection projection, Context& context);

/// Normals and tangents of a valid scene by <rakelight/geometry/attributes.h> over the whole scene.
struct SmoothSceneOptions {
    AttributeOptions attributes;
    bool only_missing = false;  ///< keep existing normals; compute the others
    /// Overrides attributes.tangent_mode for all meshes. Absent: that mode for computed normals, MikkTSpace for kept
    /// ones.
    std::optional<TangentMode> tangents;
};
Scene smooth_scene(const Scene& scene, const SmoothSceneOptions& options, Context& context);

/// The Utah teapot from Newell's 32 Bezier patches, as six objects (rim, body, handle, spout, lid, bottom) with their
/// patch u, v; no normals (prepare_scene() computes them). `divisions` quads per side of each patch, 1..256.
/// @param memory charged for the arrays before they are created; may be null. Border positions of adjacent patches are
///         bit-equal
Scene make_teapot(int divisions = 10, MemoryBudget* memory = nullptr);
/// The divisions for which facets are within `tolerance` [m], > 0, of the patch at equal u, v.
/// @throws Error usage: more than 256 would be needed
int teapot_divisions(double tolerance);

}  // namespace rakelight
