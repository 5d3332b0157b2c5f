// SPDX-License-Identifier: Apache-2.0
// Last pass over an OBJ file: faces, lines and points, and the state that applies to them (o, g, usemtl, s).
#pragma once
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/obj/obj_lines.h"
#include "io/obj/obj_meshes.h"

namespace rakelight::io::obj {

/// Index into Scene::materials for the name after usemtl on this line, at its first use; the empty name for faces
/// without one.
using FindMaterial = std::function<std::uint32_t(const std::string& name, std::uint64_t line)>;

/// A face as it was read: its line, the mesh (into Elements::meshes) and the place in that mesh's indices where its triangles
/// begin, its corners (without normals where one of them has none), and the corner numbers of its triangles.
struct ReadFace {
    const Line& line;
    std::size_t mesh = 0, first_index = 0;
    std::span<const Corner> corners;
    std::span<const std::uint32_t> triangles;
};
using FaceObserver = std::function<void(const ReadFace& face)>;

struct Elements {
    std::vector<std::string> objects;  ///< names, in order of their first face, line or point
    MeshSet meshes;                    ///< MeshKey::object counts `objects`
    MemoryCharge charge;               ///< pays for the names, the table of meshes and what grows in it
    std::uint64_t drawable = 0;        ///< triangles, segments and points whose corners are all finite
};

/// Objects: every `o` line begins one; in a file without `o` every new name after `g` does, and a name that comes again
/// goes on with its object (a group is a set by name). Only those with elements count. Meshes: one for each material,
/// topology and presence of normals in an object, so `usemtl` back to an earlier material goes on with its mesh.
/// Positive indices may point forward; a face whose vertex index is 0 or out of range is skipped, a texture coordinate
/// or normal index of that kind makes the corner one without.
/// @param default_object  name of the object of faces before the first `o` or `g`
/// @param observe  called for every face that is read, in the order of the file; may be empty
/// @throws Error bad_file: over the memory limit; failed: cancelled
Elements read_elements(std::string_view file, const Contents& contents, const VertexData& data,
                       const std::string& default_object, const FindMaterial& find_material, Remarks& remarks,
                       Context& context, const FaceObserver& observe = {});

}  // namespace rakelight::io::obj
