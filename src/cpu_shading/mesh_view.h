// SPDX-License-Identifier: Apache-2.0
// A draw's mesh as kernels read the corners of its triangles. C headers only: read by kernels of every instruction set.
#pragma once
#include <stdint.h>

namespace rakelight::cpu_shading {

struct MeshView {
    const uint32_t* indices;  ///< [3 * triangles]
    int32_t vertices;
    const float* positions;               ///< [vertices] of 3
    const float* normals;                 ///< [vertices] of 3; null: those of the faces
    const float* tangents;                ///< [vertices] of 4; null: none
    const float* bitangents;              ///< [vertices] of 3; null: by the cross product
    const float* texcoords[2];            ///< [vertices] of 2; null: none
    const float* colors;                  ///< [vertices] of 4; null: white
    float to_normal[3][3], linear[3][3];  ///< rows of the matrices object -> world axes, for normals and for tangents
    float mirror;                         ///< -1: the placement mirrors (DrawFrame::mirror())
    int32_t turned;                       ///< 1: normals are turned round where the front is seen, not the back
    const int32_t* against;               ///< [triangles] 1: the other way round for this one; null: for none
};

}  // namespace rakelight::cpu_shading
