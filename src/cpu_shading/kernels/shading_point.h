// SPDX-License-Identifier: Apache-2.0
// A vector of points of one draw, as the engine that found them knows them. Per instruction set.
#pragma once
#include "cpu_shading/kernels/sample.h"

namespace rakelight::cpu_shading::RL_ISA {

/// A vector, and the sign that goes with it.
struct SignedVector {
    vec3 v;
    real sign;
};

/// What an engine fills in, stage by stage, as far as the job asks for it (shade_points.h).
struct ShadingPoint {
    vec3 position;           ///< about the eye, world axes
    TexCoords texcoords[2];  ///< of the mesh's sets that some map is read by
    vec4 color;              ///< of the vertices
    SignedVector normal;     ///< interpolated, not unit; -1: it is to be turned round to be on the seen side
    SignedVector tangent;    ///< interpolated, not unit, 0 where the mesh has none; handedness +1, -1

    // Where the maps are read: find_map_place().
    int32_t anisotropy;    ///< MaterialJob::anisotropy
    uint32_t shared_maps;  ///< MaterialView::shared_maps, 0 where each is read for itself
    Footprint footprint;   ///< of the shared ones
};

/// Positions and frames of the corners of each point's triangle: for lighting in the vertices' tangent space, and for bitangents that
/// are attributes of their own.
struct CornerFrames {
    vec3 position[3], normal[3], tangent[3], bitangent[3];
    real handedness;
};

}  // namespace rakelight::cpu_shading::RL_ISA
