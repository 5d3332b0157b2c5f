// SPDX-License-Identifier: Apache-2.0
// The corners of all chunks as vertices of meshes.
#pragma once
#include <vector>

#include "io/obj/obj_meshes.h"

namespace rakelight::io::obj {

/// Fills corners, indices, smoothing and polygons of all meshes. A mesh's corners are numbered in order of first use in the file,
/// whatever the chunks.
/// @param places  of the runs of each chunk; the meshes' index_count and has_polygons are known
/// @param charge  grows by what the meshes take
/// @throws Error bad_file: over the memory limit, more than 2^32 - 2 corners in a mesh
void merge_corners(const std::vector<ChunkElements>& chunks, const std::vector<ChunkPlaces>& places,
                   std::vector<ReadMesh>& meshes, bool has_smoothing, MemoryCharge& charge, Context& context);

}  // namespace rakelight::io::obj
