// SPDX-License-Identifier: Apache-2.0
// Repairs faults in vertex arrays of files, before anything is computed from them.
#pragma once
#include <string>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// A remark about one mesh; added in the order of the meshes, for any number of threads.
struct Finding {
    Remark remark;
    std::string message;
};

/// Drops triangles with non-finite positions (with their smoothing groups); such positions become 0. Warns if all
/// triangles are degenerate, and of coordinates whose products exceed the float range.
void repair_positions(Mesh& mesh, std::vector<Finding>& findings);

/// Non-finite texture coordinates become 0. Warns of huge ones, and of constant ones if the mesh has a texture
/// (`is_textured`).
void repair_texcoords(Mesh& mesh, bool is_textured, std::vector<Finding>& findings);

/// Normalizes normals of the file. If all are zero or non-finite, the array is dropped; single ones become zero, for
/// smooth_meshes() to make them.
void repair_normals(Mesh& mesh, std::vector<Finding>& findings);

/// Normalizes tangents of the file. The array is dropped without normals, or if one is zero, non-finite or parallel to
/// its normal, or its w is not +1 or -1.
void repair_tangents(Mesh& mesh, std::vector<Finding>& findings);

/// Warns of drawn nodes with singular matrices, and of zero quaternions.
void check_nodes(const Scene& scene, Report& report);

/// All of the above over the drawn triangle meshes. Normals and tangents unused by normal_rule() are dropped without
/// checks.
/// @throws Error bad_file "nothing to draw" when no triangle is left and there are no lines or points
Scene repair_scene(Scene scene, NormalSource source, Context& context);

}  // namespace rakelight
