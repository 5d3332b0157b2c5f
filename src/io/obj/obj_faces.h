// SPDX-License-Identifier: Apache-2.0
// Faces, lines and points of all chunks, put together into objects and meshes.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "io/obj/chunk_elements.h"
#include "io/obj/obj_meshes.h"

namespace rakelight::io::obj {

/// Index into Scene::materials for the name after usemtl on this line, at its first use; the empty name for faces
/// without one.
using FindMaterial = std::function<std::uint32_t(const std::string& name, std::uint64_t line)>;

struct Elements {
    std::vector<std::string> objects;   ///< names, in order of their first face, line or point
    std::vector<ReadMesh> meshes;       ///< in order of first use; MeshKey::object counts `objects`
    std::vector<ChunkElements> chunks;  ///< of Contents::chunks; empty where they are not kept
    std::vector<ChunkPlaces> places;    ///< [chunks] where their runs went
    MemoryCharge charge;         ///< pays for the names, the table of meshes and what stands in it, and the chunks
    std::uint64_t drawable = 0;  ///< triangles, segments and points whose corners are all finite
};

/// Objects: every `o` line begins one; in a file without `o` every new name after `g` does, and a name that comes again
/// continues with its object (a group is a set by name). Only those with elements count. Meshes: one for each material,
/// topology and presence of normals in an object, so `usemtl` back to an earlier material continues with its mesh.
/// Positive indices may point forward; a face whose vertex index is 0 or out of range is skipped, a texture coordinate
/// or normal index of that kind makes the corner one without.
/// @param default_object  name of the object of faces before the first `o` or `g`
/// @param keep  the chunks and their faces are wanted too
/// @throws Error bad_file: over the memory limit; failed: cancelled
Elements read_elements(std::string_view file, const Contents& contents, const VertexData& data,
                       const std::string& default_object, const FindMaterial& find_material, Remarks& remarks,
                       Context& context, bool keep = false);

}  // namespace rakelight::io::obj
