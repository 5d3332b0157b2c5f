// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "cpu_shading/mesh_view.h"
#include "shading/draw_frame.h"

namespace rakelight::cpu_shading {

/// @param mesh  of the frame's draw, with triangles; the view points into both
MeshView make_mesh_view(const Mesh& mesh, const shading::DrawFrame& frame);

}  // namespace rakelight::cpu_shading
