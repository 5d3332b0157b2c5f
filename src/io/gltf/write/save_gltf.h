// SPDX-License-Identifier: Apache-2.0
// Writes a glTF file back with new normals and tangents; everything else in it is kept.
//
// Only these change:
// - NORMAL and TANGENT of drawn triangle primitives
// - indices and the other attributes where a vertex was split (elements are copied as they are)
// - Draco primitives, which are decompressed
// - nodes whose placement needs different normals, which get a copy of their mesh
//
// New data goes to the end of the binary chunk (GLB) or to a new buffer file.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/scene/scene.h>

#include "io/reader.h"

namespace rakelight::io {

struct GltfSaveOptions {
    ReadOptions read;
    bool keep_instances =
        false;  ///< placements of one mesh continue sharing it: with the attributes of the first placement
    bool keep_unused = false;  ///< GLB: bytes of views that nothing refers to stay
};

/// What was written for one primitive.
struct SavedPrimitive {
    std::uint32_t mesh = 0, primitive = 0;  ///< in the file that was written
    std::uint32_t scene_mesh = 0;           ///< into the meshes of `after`
    bool changed = false;                   ///< false: its attributes were these already
};

struct GltfSaveResult {
    bool changed = false;  ///< false: the attributes were these already, to rounding; the file was copied byte by byte
    std::uint32_t meshes_added = 0;
    std::vector<SavedPrimitive> primitives;
};

/// @param before  what gltf_reader made of `source`  @param after  the same scene with other normals, tangents, splits
/// and
///                mesh copies (smooth_scene() and the like); nodes and the first meshes in the order of `before`
/// @param output  .glb or .gltf; may be `source` itself. A .gltf file gets its new data in NAME.bin beside it; the
/// files that
///                it refers to are copied when it lies in another folder. A .gltf source written as .glb takes its
///                buffers in.
/// @throws Error failed: a file to be copied would replace another one; over 4 GiB; cannot write
GltfSaveResult save_gltf(const std::string& source, const Scene& before, const Scene& after, const std::string& output,
                         const GltfSaveOptions& options, Context& context);

}  // namespace rakelight::io
