// SPDX-License-Identifier: Apache-2.0
// Preparation of a scene for an engine: normals, tangents, and texture coordinates for models without them.
#pragma once
#include <cstdint>
#include <optional>

#include <rakelight/attributes.h>
#include <rakelight/export.h>
#include <rakelight/matching_borders.h>
#include <rakelight/scene.h>
#include <rakelight/seams.h>

namespace rakelight {

/// Projection for computed texture coordinates.
enum class UvProjection : std::uint8_t { none, box, sphere, cylinder };

/// Displacement mapping: height maps as geometry.
struct Displacement {
    bool is_on = false;  ///< for materials with Bump::automatic; materials with Bump::displacement are always displaced
    Relief relief{};     ///< depth, bias and polarity for materials without their own
    double edge = 0;     ///< [m] in world space: longer triangle edges are split; 0: 1/250 of the model's diagonal
    std::uint64_t max_triangles = 4'000'000;  ///< limit for the displaced meshes; splitting stops there, with a warning
    bool operator==(const Displacement&) const = default;
};

/// Options of prepare_scene().
struct PrepareOptions {
    NormalSource normals = NormalSource::automatic;  ///< `automatic`: Mesh::normal_choice applies if present
    CornerWeight weight = CornerWeight::angle;
    double crease_angle_rad = radians(60);  ///< for meshes without an applicable angle in Mesh::normal_choice
    double weld_distance = -1;              ///< [m] AttributeOptions::weld_distance
    /// [m] in world space, finite: adjacent borders of different meshes at most this far apart get matching normals
    /// (<rakelight/matching_borders.h>); 0: off. Meshes match within the scope of their smoothing (`face`: none). With
    /// `automatic`, normals of the file are joined as by `seams`; with `file` they are not changed.
    double border_distance = 0;
    UvProjection uv = UvProjection::none;  ///< for meshes without texture coordinates
    /// How tangents are computed; overrides tangents of the file. Absent: the file's; else MikkTSpace if the file's
    /// normals are kept (its maps were baked for them); else averaged.
    std::optional<TangentMode> tangents{};
    Orthogonalize orthogonalize = Orthogonalize::attribute;
    /// Keeps the bitangents of the published modes of `tangents` as a separate attribute (Mesh::bitangents), instead of
    /// cross(normal, tangent) w. Frames are then not always orthogonal. Animated meshes use the cross product.
    bool bitangents = false;
    /// Report the deviation of tangents from perpendicular to the normals, before orthogonalization.
    bool measure_orthogonality = false;
    /// Tangents for all meshes with texture coordinates, not only for those with a normal or height map: for
    /// channel_tangent.
    bool all_tangents = false;
    /// Instances keep sharing one mesh, with the normals of the first instance, even if their neighbors differ.
    bool keep_instances = false;
    /// Front faces are clockwise: normals, tangents and texture coordinates are computed for that side. render() and
    /// render_picture() set it from RenderSettings::front_face.
    bool clockwise_fronts = false;
    Bump bump = Bump::automatic;  ///< for materials with Bump::automatic: decides which maps are needed
    Subdivision subdivision{};    ///< for meshes without their own; before displacement
    Displacement displacement{};
    bool tessellate = false;  ///< removes Mesh::shape: every engine draws the triangles of built-in shapes
    bool operator==(const PrepareOptions&) const = default;
};

/// A scene that an engine can draw: every triangle mesh has finite unit normals, and tangents if a normal or height map
/// needs them. The report lists replaced data (zero or non-finite normals of the file, tangents with w = 0, ...).
RL_API Scene prepare_scene(Scene scene, const PrepareOptions& options, Context& context);

/// The scene with its pose applied, as static geometry. Nodes get the transforms of Scene::pose. Each instance of a
/// skinned or morphed mesh gets its own vertices (glTF 2.0, sections 3.7.2.2 and 3.7.3): positions, and existing
/// normals and tangents. Normals are transformed by the cofactor of the blended matrix and normalized. Vertices of
/// skinned instances are in world space: the node has no parent and no transform, and its children keep their place.
/// Skins, clips, targets and pose are removed. Other meshes share their arrays with the input. Bit-identical for any
/// number of threads.
/// @throws Error bad_file: see validate(), over the memory budget
RL_API Scene posed_scene(const Scene& scene, Context& context);

/// Whether posed_scene() changes anything.
RL_API bool is_posable(const Scene& scene);

/// Applies join_seams() (<rakelight/seams.h>) to all drawn triangle meshes with normals, in world space, skinned ones
/// in bind pose. Tangents and normal offsets of morph targets rotate with their normals. All other data stays
/// bit-identical, and unchanged arrays stay shared. Instances with different results get meshes of their own.
/// @param keep_instances instances keep sharing one mesh, with the normals of the first; the report mentions it
/// @param seams not null: gets the statistics
RL_API Scene repair_seams(const Scene& scene, const SeamOptions& options, Context& context, SeamReport* seams = nullptr,
                          bool keep_instances = false);

/// Applies join_borders() (<rakelight/matching_borders.h>) to the same meshes: normals agree along adjacent borders
/// without shared vertices. Tangents, morph targets, shared arrays and instances as above. For scenes without
/// animation; prepare_scene() handles poses.
/// @param keep_instances as above
/// @param borders not null: gets the statistics
RL_API Scene repair_borders(const Scene& scene, const MatchOptions& options, Context& context,
                            MatchReport* borders = nullptr, bool keep_instances = false);

}  // namespace rakelight
