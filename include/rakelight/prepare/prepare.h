// SPDX-License-Identifier: Apache-2.0
// Preparation of a scene for an engine: normals, tangents, and texture coordinates for models without them.
#pragma once
#include <cstdint>
#include <optional>

#include <rakelight/base/export.h>
#include <rakelight/geometry/attributes.h>
#include <rakelight/geometry/matching_borders.h>
#include <rakelight/geometry/seams.h>
#include <rakelight/scene/scene.h>
#include <rakelight/scene/words.h>

namespace rakelight {

/// Projection for computed texture coordinates.
enum class UvProjection : std::uint8_t { none, box, sphere, cylinder };

/// Displacement mapping: height maps as geometry.
struct Displacement {
    bool is_on = false;  ///< for materials with Bump::automatic; materials with Bump::displacement are always displaced
    Relief relief{};     ///< depth, bias and polarity for materials without Material::relief
    double edge = 0;     ///< [m] in world space: longer triangle edges are split; 0: 1/250 of the model's diagonal
    std::uint64_t max_triangles = 4'000'000;  ///< of all displaced meshes; splitting stops there, with a warning
    bool operator==(const Displacement&) const = default;
};

/// The words for weights, the default first.
inline constexpr Word<CornerWeight> corner_weight_words[] = {
    {"auto", CornerWeight::automatic}, {"angle", CornerWeight::angle}, {"uniform", CornerWeight::uniform},
    {"area", CornerWeight::area},      {"max", CornerWeight::max},     {"angle-area", CornerWeight::angle_area},
    {"fit", CornerWeight::fit}};

/// The words for creases, the default of a PictureRequest first.
inline constexpr Word<Creasing> creasing_words[] = {{"auto", Creasing::automatic}, {"angle", Creasing::angle}};

/// Options of prepare_scene().
struct PrepareOptions {
    NormalSource normals = NormalSource::automatic;  ///< `automatic`: Mesh::normal_choice applies if present
    CornerWeight weight = CornerWeight::automatic;
    double crease_angle_rad = radians(60);  ///< for meshes without an applicable angle in Mesh::normal_choice
    /// `automatic`: creases by the rule, not by crease_angle_rad, for authored normals that `seams` joins too. The angle
    /// still limits which borders match.
    Creasing creases = Creasing::angle;
    double weld_distance = -1;  ///< [m] AttributeOptions::weld_distance
    /// [m] in world space, finite, >= 0: the largest distance between adjacent borders of different meshes that get
    /// matching normals (<rakelight/geometry/matching_borders.h>). 0: off. Meshes with normals computed over the model match
    /// each other. A mesh with normals computed over its object matches only meshes of that object. A mesh with flat
    /// normals matches none. If `normals` is `file`, the normals of the file are not changed. If `normals` is
    /// `automatic`, the normals of the file are joined as with `seams`.
    double border_distance = 0;
    UvProjection uv = UvProjection::none;  ///< for meshes without texture coordinates
    /// How tangents are computed. If present, it also replaces the tangents of the file. If absent, a mesh keeps the
    /// tangents of its file. A mesh without tangents gets TangentMode::mikktspace if it keeps the normals of its file,
    /// because normal maps are usually baked for such tangents. All other meshes get TangentMode::averaged.
    std::optional<TangentMode> tangents{};
    Orthogonalize orthogonalize = Orthogonalize::attribute;  ///< AttributeOptions::orthogonalize
    /// Keeps the bitangents of the published modes of `tangents` as a separate attribute (Mesh::bitangents). Otherwise
    /// the bitangent is cross(normal, tangent) w. With separate bitangents, frames are not always orthogonal. Animated
    /// meshes always use the cross product.
    bool bitangents = false;
    /// Report how far tangents are from the plane perpendicular to the normal, before orthogonalization.
    bool measure_orthogonality = false;
    /// Compute tangents for all meshes with texture coordinates, as channel_tangent needs them. false: only for meshes
    /// with a normal map or height map.
    bool all_tangents = false;
    /// All instances of a mesh keep sharing it, with the normals of the first instance. false: an instance whose
    /// neighbors require other normals gets a mesh of its own.
    bool keep_instances = false;
    /// Front faces are clockwise: normals, tangents and texture coordinates are computed for the clockwise side.
    /// render() and render_picture() set this member from RenderSettings::front_face.
    bool clockwise_fronts = false;
    Bump bump = Bump::automatic;  ///< for materials with Bump::automatic: decides which maps are needed
    Subdivision subdivision{};    ///< for meshes without Mesh::subdivision; applied before displacement
    Displacement displacement{};
    bool tessellate = false;  ///< removes Mesh::shape, so that every engine draws the triangles of built-in shapes
    bool operator==(const PrepareOptions&) const = default;
};

/// A scene that an engine can draw: every triangle mesh has finite unit normals, and tangents if a normal or height map
/// needs them. The report lists replaced data (zero or non-finite normals of the file, tangents with w = 0, ...).
RL_API Scene prepare_scene(Scene scene, const PrepareOptions& options, Context& context);

/// The scene with its pose applied, as static geometry. Nodes get the transforms of Scene::pose. Each instance of a
/// skinned or morphed mesh gets its own positions, normals and tangents (glTF 2.0, sections 3.7.2.2 and 3.7.3). Normals
/// are transformed by the cofactor matrix of the blended matrix and normalized. Vertices of skinned instances are in
/// world space. Therefore the node of such an instance loses its parent and its transform; its children keep their
/// placement in the world. Skins, clips, morph targets and the pose are removed. All other meshes share their arrays
/// with the input. Bit-identical for any number of threads.
/// @throws Error bad_file: see validate(), over the memory budget
RL_API Scene posed_scene(const Scene& scene, Context& context);

/// Whether posed_scene() changes anything.
RL_API bool is_posable(const Scene& scene);

/// Applies join_seams() (<rakelight/geometry/seams.h>) in world space to all triangle meshes with normals that a node places.
/// Skinned meshes are processed in bind pose. Tangents, and the normal offsets of morph targets, rotate with their
/// normals. All other data stays bit-identical, and unchanged arrays stay shared. If the instances of a mesh get
/// different normals, each gets a mesh of its own.
/// @param keep_instances instances keep sharing one mesh, with the normals of the first one; the report has a remark
/// @param seams not null: gets the statistics
RL_API Scene repair_seams(const Scene& scene, const SeamOptions& options, Context& context, SeamReport* seams = nullptr,
                          bool keep_instances = false);

/// Applies match_borders() and join_borders() (<rakelight/geometry/matching_borders.h>) to the same meshes as repair_seams().
/// Normals then agree along adjacent borders without shared vertices. Tangents, morph targets, shared arrays and
/// instances are treated as by repair_seams(). For scenes without animation. For animated scenes use prepare_scene(),
/// which repeats this step for each pose.
/// @param keep_instances as in repair_seams()
/// @param borders not null: gets the statistics
RL_API Scene repair_borders(const Scene& scene, const MatchOptions& options, Context& context,
                            MatchReport* borders = nullptr, bool keep_instances = false);

}  // namespace rakelight
