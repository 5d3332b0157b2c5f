// SPDX-License-Identifier: Apache-2.0
// Scene -> scene, before an engine sees it: texture coordinates, normals and tangents. Untouched blocks are shared.
#pragma once
#include <optional>
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/prepare.h>
#include <rakelight/scene.h>

#include "prepare/generated_attributes.h"
#include "prepare/pose_scene.h"
#include "prepare/repair_borders.h"

namespace rakelight {

/// Functions of public headers for scenes that passed validate(), which the public ones do first.
namespace valid {
Scene prepare_scene(Scene scene, const PrepareOptions& options, Context& context);
}

/// A scene on the way: it has the normals and tangents that its rest asks for, and nothing of it has moved yet.
struct BoundScene {
    Scene scene;                              ///< without Scene::pose
    std::vector<GeneratedAttributes> made{};  ///< that have to be made again of what moves
    std::vector<BoundBorders> borders{};  ///< that have to be joined again after that: `scene` has the normals before
};
/// Whether a scene is better prepared in two halves: it can move, and the first half does not depend on the pose. (It
/// does where control nets move, and where triangles turn clockwise.)
bool has_bind_pose(const Scene& scene, const PrepareOptions& options);
/// The first half of prepare_scene(). @param scene  passed validate(), has a bind pose
BoundScene bind_scene(Scene scene, const PrepareOptions& options, Context& context);
/// The second, for any pose: vertices, displacement, tangents that are still missing.
/// @param pose  of the nodes; absent: as they are
Scene finish_scene(BoundScene bound, const Rare<ScenePose>& pose, const PrepareOptions& options, Context& context);
/// The same, but that meshes whose vertices nothing in prepare asks for are left in bind pose.
UnposedScene finish_unposed(BoundScene bound, const Rare<ScenePose>& pose, const PrepareOptions& options,
                            Context& context);

/// @throws Error usage: a number out of range, an invalid enumerator
void check_options(const PrepareOptions& options);

/// Texture coordinates by projection about the world bounding box, for triangle meshes of a valid scene that have none;
/// reported.
Scene project_texcoords(Scene scene, UvProjection projection, Context& context);

/// Normals and tangents of a valid scene by the door of <rakelight/attributes.h> over the whole scene.
struct SmoothSceneOptions {
    AttributeOptions attributes;
    bool only_missing = false;  ///< keep existing normals; compute the others
    /// In place of attributes.tangent_mode, for all. Unset: that mode where normals are made, MikkTSpace where they are kept.
    std::optional<TangentMode> tangents;
};
Scene smooth_scene(const Scene& scene, const SmoothSceneOptions& options, Context& context);

/// The Utah teapot from Newell's 32 Bezier patches, as six objects (rim, body, handle, spout, lid, bottom) with their
/// patch u, v; no normals (prepare makes them). `divisions` quads a side of each patch, 1..256.
/// @param memory charged for the arrays before they are created; may be null Adjacent patches share border curves and
///         divisions, so their border positions are bit-equal.
Scene make_teapot(int divisions = 10, MemoryBudget* memory = nullptr);
/// The divisions with which no point of a facet is farther than `tolerance` [m], > 0, from the point of the patch at
/// its u, v.
/// @throws Error usage: there would have to be more than 256
int teapot_divisions(double tolerance);

}  // namespace rakelight
