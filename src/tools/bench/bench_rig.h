// SPDX-License-Identifier: Apache-2.0
// The character of the measurements of poses: the displaced sphere of the measurements of attributes, with a skeleton.
#pragma once
#include <cstdint>

#include <rakelight/scene/scene.h>

namespace rakelight {

/// Parts of one sphere that follow one chain of joints, four to each vertex, and a clip of a second that bends it. A brick
/// wall's normal map on texture coordinates; no normals, so that they are made.
/// @param triangles  about; 100 to 10^8 @param joints  2 to 1000
Scene make_bench_rig(std::uint64_t triangles, std::uint32_t objects, std::uint32_t joints);

}  // namespace rakelight
