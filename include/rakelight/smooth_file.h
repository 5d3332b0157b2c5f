// SPDX-License-Identifier: Apache-2.0
// Repair and save: a model file in, the same file with seam-free normals and tangents out.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/inspect.h>
#include <rakelight/matching_borders.h>
#include <rakelight/render.h>
#include <rakelight/scene.h>
#include <rakelight/seams.h>

namespace rakelight {

/// Which meshes get tangents. `automatic`: those whose material has a normal or height map, and those that had
/// tangents. `always`: all that have texture coordinates. `never`: none; tangents of the file go, since they belong to
/// its old normals.
enum class TangentChoice : std::uint8_t { automatic, always, never };

/// What happens to normals that the file has. `seams`: they stay, but are joined where meshes meet by the rule of
/// <rakelight/seams.h>; tangents turn along. `replaced`: they are made anew by SmoothFileOptions::attributes.
enum class AuthoredNormals : std::uint8_t { seams, replaced };

struct SmoothFileOptions {
    /// `normals` and `tangents` are not read: tangents are made by the choice. Of these the crease angle and the weld distance hold
    /// for `seams` too; meshes without normals get them by all.
    AttributeOptions attributes{};
    AuthoredNormals authored = AuthoredNormals::seams;
    /// [m] in the world, finite, >= 0: normals agree along borders at most this far apart, too
    /// (<rakelight/matching_borders.h>), within attributes.scope (face: none do); 0: off.
    double border_distance = 0;
    TangentChoice tangents = TangentChoice::automatic;
    bool bitangents = false;      ///< glTF: those of the published modes are written, as the attribute _BITANGENT
    bool keep_unused = false;     ///< glTF: bytes of buffer views that nothing uses any more stay in the file
    bool keep_instances = false;  ///< glTF: placements of one mesh go on sharing it, with the first one's attributes
    LoadOptions load{};
};

/// What happened to one mesh of the output (glTF: one primitive).
struct SmoothedMesh {
    std::string name{};
    std::uint32_t mesh = no_index, primitive = no_index;  ///< its numbers in the output where it is glTF
    std::uint64_t vertices = 0;                           ///< before
    std::uint64_t vertices_split = 0;  ///< copies that were added because corners of one vertex differ
    enum class Change : std::uint8_t {
        none,
        kept,
        made,
        replaced,
        removed,
        turned
    };  ///< turned: some of them, the others kept
    Change normals = Change::kept, tangents = Change::none;
};

struct SmoothedFile {
    std::string file{}, output{};
    bool changed = false;  ///< false: the normals and tangents were these already; the file was copied byte by byte
    std::uint32_t meshes_added = 0;  ///< glTF: copies for placements that need normals of their own
    std::vector<SmoothedMesh> meshes{};
    std::optional<SeamReport> seams{};     ///< where authored normals were kept
    std::optional<MatchReport> borders{};  ///< where there was a border distance
};

/// Reads `input` (a model or a world), repairs or makes its normals and tangents over all its objects (skinned models in bind
/// pose) and writes `output`: glTF or GLB to glTF or GLB and OBJ to OBJ in place, everything else of the file kept; any
/// format to .glb, .gltf, .obj or .ply by a writer of its own, which says in the report what it cannot express (OBJ and PLY: at
/// their places in the world, the normals those of the rounded positions; PLY: one mesh; `meshes` then lists each placement). Textures
/// are not decoded. `output` may be `input`; in another folder the files that the model names are copied beside it, none is
/// replaced. A second run over the output changes nothing. The output appears when it is whole.
/// @throws Error usage (no way from the one format to the other), not_found, bad_file, failed (cannot write)
SmoothedFile smooth_file(const std::string& input, const std::string& output, const SmoothFileOptions& options,
                         Context& context);

/// Where the pages of a preview go.
struct PreviewPlace {
    std::string page{};                             ///< an .html file
    std::string picture_before{}, picture_after{};  ///< .png files beside it; empty: the pictures are in the page alone
};

/// What smooth_file() would do to `input`, written as a page: heat maps of the seams before and after (draw_seams()), one view
/// and size, and the borders with the largest seams. No model is written.
/// @return as smooth_file(); `output` is the page
SmoothedFile preview_smooth(const std::string& input, const PreviewPlace& place, const SmoothFileOptions& options,
                            const ViewRequest& view, const RenderSettings& settings, Context& context);

/// One line for people: what was written and how much of it changed.
std::string summary(const SmoothedFile& result);

}  // namespace rakelight
