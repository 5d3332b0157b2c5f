// SPDX-License-Identifier: Apache-2.0
// A draw list of meshes in bind pose: with the boxes of where they stand.
#pragma once
#include "geometry/pose/mesh_pose.h"
#include "shading/draw_list.h"

namespace rakelight::shading {

/// As make_draw_list() of draw_list.h makes it of the posed meshes, to the bit, except for their arrays.
/// @param poses  of the meshes that are in bind pose
DrawList make_draw_list(Scene scene, const geometry::MeshPoses& poses, TextureCache& textures,
                        const TexturePacker& packer, Context& context);

}  // namespace rakelight::shading
