// SPDX-License-Identifier: Apache-2.0
// Repairs a model file: writes it with seam-free normals and tangents.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/geometry/attributes.h>
#include <rakelight/geometry/matching_borders.h>
#include <rakelight/geometry/seams.h>
#include <rakelight/render/render.h>
#include <rakelight/scene/scene.h>
#include <rakelight/tools/inspect.h>
#include <rakelight/tools/report_row.h>
#include <rakelight/world/request.h>

namespace rakelight {

/// Which meshes get tangents.
/// - `automatic`: meshes that have tangents, and meshes with a normal map or height map in their material.
/// - `always`: all meshes with texture coordinates.
/// - `never`: none. Tangents of the file are removed, because they belong to the old normals.
enum class TangentChoice : std::uint8_t { automatic, always, never };

/// Options of smooth_file().
struct SmoothFileOptions {
    /// The members attributes.normals and attributes.tangents are ignored. With AuthoredNormals::seams, only crease
    /// angle and weld distance apply to existing normals. Meshes without normals use all options.
    AttributeOptions attributes{};
    AuthoredNormals authored = AuthoredNormals::seams;  ///< `replaced`: all normals are new, by `attributes`
    /// [m] in world space, finite, >= 0; 0: off. Also matches normals along borders that are at most this far apart
    /// (<rakelight/geometry/matching_borders.h>). Only meshes within one attributes.scope match; with Scope::face no meshes
    /// match.
    double border_distance = 0;
    TangentChoice tangents = TangentChoice::automatic;
    bool bitangents = false;      ///< glTF: write bitangents of the published modes as the attribute _BITANGENT
    bool keep_unused = false;     ///< glTF: keep unused buffer views in the file
    bool keep_instances = false;  ///< glTF: instances keep sharing one mesh, with the attributes of the first instance
    LoadOptions load{};
};

/// The options by the settings of a picture: creases, weight, border distance, instances, and how files are loaded.
RL_API SmoothFileOptions smooth_options_for(const PictureRequest& request);

/// Changes of one mesh of the output (glTF: one primitive).
struct SmoothedMesh {
    std::string name{};                                   ///< for people; may be empty
    std::uint32_t mesh = no_index, primitive = no_index;  ///< indices of mesh and primitive in glTF output
    std::uint64_t vertices = 0;                           ///< number of vertices before
    std::uint64_t vertices_split = 0;                     ///< number of vertices added by splits
    /// The change of an attribute. `turned`: some vectors were rotated, the others were kept.
    enum class Change : std::uint8_t { none, kept, made, replaced, removed, turned };
    Change normals = Change::kept, tangents = Change::none;
};

/// Result of smooth_file().
struct SmoothedFile {
    std::string file{}, output{};  ///< as they were named
    /// The other files that were smoothed as one model with it. `seams`, `borders` and `missing_made` count over all.
    std::vector<std::string> together{};
    bool changed = false;            ///< false: normals and tangents were already right; the file was copied unchanged
    std::uint32_t meshes_added = 0;  ///< glTF: number of copies for instances that need their own normals
    /// Where authored normals were kept: number of vertices that had no normal, a zero or a non-finite one, and got one.
    std::uint64_t missing_made = 0;
    std::vector<SmoothedMesh> meshes{};
    std::optional<SeamReport> seams{};     ///< if authored normals were kept
    std::optional<MatchReport> borders{};  ///< if there was a border distance
};

/// Reads `input` (a model or a world), repairs or computes normals and tangents over all its objects, and writes
/// `output`. Skinned models are in bind pose. Textures are not decoded. A second run over the output changes nothing.
///
/// From glTF or GLB to glTF or GLB, and from OBJ to OBJ, all other data of the file is kept. All other conversions to
/// .glb, .gltf, .obj or .ply use a generic writer, and the report lists what this writer cannot express. In OBJ and
/// PLY all instances are in world space, and new normals are computed from the rounded positions. A PLY file has one
/// mesh, but SmoothedFile::meshes has an entry for each instance.
///
/// `output` may be `input`. If it is in another folder, referenced files are copied to that folder, without replacing
/// existing files. The output appears complete or not at all.
/// @throws Error usage: no conversion between the formats; not_found; bad_file; failed: the output cannot be written
RL_API SmoothedFile smooth_file(const std::string& input, const std::string& output, const SmoothFileOptions& options,
                                Context& context);

/// A file of several that belong together.
struct FileToSmooth {
    std::string input{}, output{};  ///< as for smooth_file()
};

/// Smooths several files as one model, each in its own coordinates: normals agree across the borders between the files
/// too. Each file is written to its own output, in the ways of smooth_file(). All outputs appear, or none.
/// @return one entry for each file. `seams` and `borders` count over all files
/// @throws Error as smooth_file(); usage: two files have one output; failed: two outputs need another file of one name,
///         such as a texture, with different content
RL_API std::vector<SmoothedFile> smooth_files(std::span<const FileToSmooth> files, const SmoothFileOptions& options,
                                              Context& context);

/// Result of files_cut_apart().
struct FilesCutApart {
    /// [files] the index of the first file of the same surface; its own index if there is none before it
    std::vector<std::uint32_t> first{};
    /// Files with open edges that fit those of two other files or more, ascending. It is not clear which two belong
    /// together, so these edges do not count.
    std::vector<std::uint32_t> unclear{};
};

/// Which files hold pieces of one surface: at least two open edges of one file are open edges of another one, in world
/// space, and their faces lie on opposite sides of them. So variants of one model, and models that only touch, are
/// apart. Reads all files, one at a time; a file that cannot be read is apart.
/// @throws Error bad_file: over the memory budget; failed: cancelled
RL_API FilesCutApart files_cut_apart(std::span<const std::string> files, const SmoothFileOptions& options,
                                     Context& context);

/// Output of a preview.
struct PreviewPlace {
    std::string page{};  ///< an .html file
    /// .png files in the folder of the page. Empty: the pictures are embedded in the page.
    std::string picture_before{}, picture_after{};
};

/// Writes a page with the changes that smooth_file() would make to `input`: heat maps of the seams before and after
/// (draw_seams()), and the borders with the largest seams. No model is written.
/// @return as smooth_file(); `output` is the page
RL_API SmoothedFile preview_smooth(const std::string& input, const PreviewPlace& place,
                                   const SmoothFileOptions& options, const ViewRequest& view,
                                   const RenderSettings& settings, Context& context);

/// One line: what was written and how much changed. Of a file that was smoothed together with others, it leaves out
/// what is counted over all of them.
RL_API std::string summary(const SmoothedFile& result);
/// What is counted over all files that were smoothed as one model; empty if nothing is.
RL_API std::string summary_of_all(const SmoothedFile& result);

/// A row of `smooth --json`.
struct SmoothedFileRow : ReportRow {
    std::string file{};  ///< as it was named
    std::optional<SmoothedFile> result{};
};

/// {"schema": "rakelight.smooth/1", "rows": [...]}
RL_API std::string to_json(std::span<const SmoothedFileRow> rows);

}  // namespace rakelight
