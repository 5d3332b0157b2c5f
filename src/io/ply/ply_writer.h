// SPDX-License-Identifier: Apache-2.0
// A scene as one PLY file: binary little-endian, all triangles of all objects in the world.
#pragma once
#include <string>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight::io {

/// Vertices with x, y, z [m, world] and, where every mesh has them: nx, ny, nz (unit), s, t (v up, as is the custom in
/// PLY); faces as lists of three. Where the first byte of the data would be white space, which
/// readers skip, each vertex begins with a byte "pad". Instances are written out each. Skinned objects stand in bind
/// pose. What PLY cannot store (objects, materials, textures, tangents, lines, points, lights, cameras) is reported.
/// @throws Error bad_file "nothing to write" without a triangle, or over 2^31 vertices; failed: cannot write
void write_ply(const Scene& scene, const std::string& path, Context& context);

}  // namespace rakelight::io
