// SPDX-License-Identifier: Apache-2.0
// Repairs a model file: writes it with seam-free normals and tangents.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/export.h>
#include <rakelight/inspect.h>
#include <rakelight/matching_borders.h>
#include <rakelight/render.h>
#include <rakelight/scene.h>
#include <rakelight/seams.h>

namespace rakelight {

/// Which meshes get tangents. `automatic`: meshes whose material has a normal or height map, and meshes with tangents.
/// `always`: all with texture coordinates. `never`: none; the file's tangents are removed, because they belong to its
/// old normals.
enum class TangentChoice : std::uint8_t { automatic, always, never };

/// Treatment of the file's normals. `seams`: kept, but joined where meshes meet (<rakelight/seams.h>); tangents rotate
/// with them. `replaced`: computed by SmoothFileOptions::attributes.
enum class AuthoredNormals : std::uint8_t { seams, replaced };

/// Options of smooth_file().
struct SmoothFileOptions {
    /// `normals` and `tangents` are ignored; see `tangents` below. With AuthoredNormals::seams, only crease angle and
    /// weld distance apply to existing normals; meshes without normals use all options.
    AttributeOptions attributes{};
    AuthoredNormals authored = AuthoredNormals::seams;
    /// [m] in world space, finite, >= 0: also match normals along borders at most this far apart
    /// (<rakelight/matching_borders.h>), within attributes.scope (face: none); 0: off.
    double border_distance = 0;
    TangentChoice tangents = TangentChoice::automatic;
    bool bitangents = false;      ///< glTF: write bitangents of the published modes as the attribute _BITANGENT
    bool keep_unused = false;     ///< glTF: keep unused buffer views in the file
    bool keep_instances = false;  ///< glTF: instances keep sharing one mesh, with the attributes of the first
    LoadOptions load{};
};

/// Changes of one mesh of the output (glTF: one primitive).
struct SmoothedMesh {
    std::string name{};                                   ///< for people; may be empty
    std::uint32_t mesh = no_index, primitive = no_index;  ///< its indices in glTF output
    std::uint64_t vertices = 0;                           ///< before
    std::uint64_t vertices_split = 0;                     ///< vertices added because corners of one vertex differ
    /// The change of an attribute.
    enum class Change : std::uint8_t {
        none,
        kept,
        made,
        replaced,
        removed,
        turned
    };  ///< turned: some rotated, the others kept
    Change normals = Change::kept, tangents = Change::none;
};

/// Result of smooth_file().
struct SmoothedFile {
    std::string file{}, output{};    ///< as they were named
    bool changed = false;            ///< false: normals and tangents were already right; the file was copied unchanged
    std::uint32_t meshes_added = 0;  ///< glTF: copies for instances that need their own normals
    std::vector<SmoothedMesh> meshes{};
    std::optional<SeamReport> seams{};     ///< if authored normals were kept
    std::optional<MatchReport> borders{};  ///< if there was a border distance
};

/// Reads `input` (a model or a world), repairs or computes normals and tangents over all its objects, and writes
/// `output`. Skinned models are in bind pose. glTF or GLB to glTF or GLB, and OBJ to OBJ, keep all other data of the file. Other
/// conversions to .glb, .gltf, .obj or .ply use a generic writer; the report lists what it cannot express. In OBJ and
/// PLY the instances are in world space, with normals of the rounded positions; PLY has one mesh, and `meshes` lists
/// each instance. Textures are not decoded. `output` may be `input`. In another folder, referenced files are copied
/// next to it, without replacing existing files. A second run over the output changes nothing. The output appears when
/// it is complete.
/// @throws Error usage (no conversion between the formats), not_found, bad_file, failed (cannot write)
RL_API SmoothedFile smooth_file(const std::string& input, const std::string& output, const SmoothFileOptions& options,
                                Context& context);

/// Output of a preview.
struct PreviewPlace {
    std::string page{};  ///< an .html file
    std::string picture_before{},
        picture_after{};  ///< .png files next to it; empty: the pictures are embedded in the page
};

/// Writes a page with the changes that smooth_file() would make to `input`: heat maps of the seams before and after
/// (draw_seams()), and the borders with the largest seams. No model is written.
/// @return as smooth_file(); `output` is the page
RL_API SmoothedFile preview_smooth(const std::string& input, const PreviewPlace& place,
                                   const SmoothFileOptions& options, const ViewRequest& view,
                                   const RenderSettings& settings, Context& context);

/// One line: what was written and how much changed.
RL_API std::string summary(const SmoothedFile& result);

}  // namespace rakelight
