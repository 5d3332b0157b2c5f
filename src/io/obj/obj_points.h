// SPDX-License-Identifier: Apache-2.0
// OBJ files of vertices with colors and without elements, as scanners write them: points.
#pragma once
#include "io/obj/obj_vertices.h"

#include <rakelight/scene/scene.h>

namespace rakelight::io::obj {

/// Whether the vertices of a file without elements are meant to be seen: some have a color, or each has a normal.
bool is_point_cloud(const Contents& contents, const VertexData& data);

/// One object with all vertices as points; their normals where there are as many.
/// @throws Error bad_file: over the memory limit; no vertex is finite
void add_points(Scene& scene, VertexData& data, const std::string& name, Context& context);

}  // namespace rakelight::io::obj
