// SPDX-License-Identifier: Apache-2.0
// What files get wrong in vertex arrays, put right before anything is computed from them.
#pragma once
#include <string>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

/// A remark about one mesh; added in the order of the meshes, for any number of threads.
struct Finding {
    Remark remark;
    std::string message;
};

/// Triangles that touch a position that is not finite are dropped (with their smoothing groups); such positions become 0.
/// Warns of triangles that are all without area, and of numbers whose products leave the range of float.
void repair_positions(Mesh& mesh, std::vector<Finding>& findings);

/// Texture coordinates that are not finite become 0; warns of huge ones, and of coordinates that are all the same although
/// the mesh has a texture (`is_textured`).
void repair_texcoords(Mesh& mesh, bool is_textured, std::vector<Finding>& findings);

/// Normals of the file: made unit; where all of them are zero or not finite the array is dropped (the mesh then has none), where some
/// are these are computed from all faces of the mesh at their places.
void repair_normals(Mesh& mesh, std::vector<Finding>& findings, Context& context);

/// Tangents of the file: dropped without normals, and where one is zero, not finite or parallel to its normal or its w
/// is not +1 or -1; else made unit.
void repair_tangents(Mesh& mesh, std::vector<Finding>& findings);

/// Warns of drawn nodes whose matrix flattens what it places, and of rotations of no length.
void check_nodes(const Scene& scene, Report& report);

/// All of the above over the drawn triangle meshes. Normals and tangents that do not count by normal_rule() are dropped
/// unseen.
/// @throws Error bad_file "nothing to draw" when no triangle is left and there are no lines or points
Scene repair_scene(Scene scene, NormalSource source, Context& context);

}  // namespace rakelight
