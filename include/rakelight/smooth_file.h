// SPDX-License-Identifier: Apache-2.0
// Repair and save: a model file in, the same file with seam-free normals and tangents out.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/render.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Which meshes get tangents. `automatic`: those whose material has a normal or height map, and those that had
/// tangents. `always`: all that have texture coordinates. `never`: none; tangents of the file go, since they belong to
/// its old normals.
enum class TangentChoice : std::uint8_t { automatic, always, never };

struct SmoothFileOptions {
    AttributeOptions
        attributes{};  ///< `normals` and `tangents` are not read: normals are always made, tangents by the choice
    TangentChoice tangents = TangentChoice::automatic;
    bool keep_instances = false;  ///< glTF: placements of one mesh go on sharing it, with the first one's attributes
    LoadOptions load{};
};

/// What happened to one mesh of the output (glTF: one primitive).
struct SmoothedMesh {
    std::string name{};
    std::uint32_t mesh = no_index, primitive = no_index;  ///< its numbers in the output where it is glTF
    std::uint64_t vertices = 0;                           ///< before
    std::uint64_t vertices_split = 0;  ///< copies that were added because corners of one vertex differ
    enum class Change : std::uint8_t { none, kept, made, replaced, removed };
    Change normals = Change::kept, tangents = Change::none;
};

struct SmoothedFile {
    std::string file{}, output{};
    bool changed = false;  ///< false: the normals and tangents were these already; the file was copied byte by byte
    std::uint32_t meshes_added = 0;  ///< glTF: copies for placements that need normals of their own
    std::vector<SmoothedMesh> meshes{};
};

/// Reads `input`, computes normals and tangents over all its objects (skinned models in bind pose) and writes `output`:
/// glTF or GLB to glTF or GLB and OBJ to OBJ in place, everything else of the file kept; any format to .glb or .ply by
/// a writer of its own, which says in the report what it cannot express (PLY: one mesh at its place in the world, the normals
/// those of the rounded positions; `meshes` then lists each placement). Textures are not decoded. `output` may be `input`; in
/// another folder the files that the model names are copied beside it, none is replaced. A second run over the output changes
/// nothing. The output appears when it is whole.
/// @throws Error usage (no way from the one format to the other), not_found, bad_file, failed (cannot write)
SmoothedFile smooth_file(const std::string& input, const std::string& output, const SmoothFileOptions& options,
                         Context& context);

/// One line for people: what was written and how much of it changed.
std::string summary(const SmoothedFile& result);

}  // namespace rakelight
