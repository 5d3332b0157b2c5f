// SPDX-License-Identifier: Apache-2.0
// What is made ready before an engine sees a scene: normals and tangents, and texture coordinates where a model has
// none.
#pragma once
#include <cstdint>
#include <optional>

#include <rakelight/attributes.h>
#include <rakelight/matching_borders.h>
#include <rakelight/scene.h>
#include <rakelight/seams.h>

namespace rakelight {

enum class UvProjection : std::uint8_t { none, box, sphere, cylinder };

/// Height maps as geometry.
struct Displacement {
    bool is_on = false;  ///< for materials that name no bump technique; those that name displacement are in any case
    Relief relief{};     ///< depth, bias and polarity for materials that have none of their own
    double edge = 0;     ///< [m] in the world: longer edges of triangles are cut; 0: a 250th of the model's diagonal
    std::uint64_t most_triangles = 4'000'000;  ///< of the displaced meshes; cutting stops before, with a warning
    bool operator==(const Displacement&) const = default;
};

struct PrepareOptions {
    NormalSource normals = NormalSource::automatic;  ///< `automatic`: Mesh::normal_choice counts where there is one
    CornerWeight weight = CornerWeight::angle;
    double crease_angle_rad = radians(60);  ///< for meshes whose own choice has none, or does not count
    double weld_distance = -1;              ///< [m] AttributeOptions::weld_distance
    /// [m] in the world, finite: borders of different meshes at most this far apart that run along each other get normals that
    /// agree (<rakelight/matching_borders.h>); 0: off. Meshes match within the scope over which their normals are smoothed
    /// (`face`: none); the file's normals that `automatic` keeps are joined as `seams` then, those of `file` stay.
    double border_distance = 0;
    UvProjection uv = UvProjection::none;  ///< for meshes without texture coordinates
    /// How tangents are made, in place of the file's too. Unset: the file's; else as MikkTSpace where the file's normals are kept
    /// (that is what its maps were baked for); else averaged.
    std::optional<TangentMode> tangents{};
    Orthogonalize orthogonalize = Orthogonalize::attribute;
    /// The bitangents that the published modes of `tangents` average are kept as an attribute of their own (Mesh::bitangents), in
    /// place of cross(normal, tangent) w: frames need not be orthogonal then. Meshes that move keep theirs by the cross product.
    bool bitangents = false;
    /// Say in the report how far from perpendicular to the normals the tangents were, before that was put right.
    bool measure_orthogonality = false;
    /// Tangents for all meshes with texture coordinates, not only for those with a normal or height map: for the
    /// channel that shows them.
    bool all_tangents = false;
    /// Placements of one mesh go on sharing it, with the normals of the first, even where they touch different things.
    bool keep_instances = false;
    /// Triangles turn clockwise as seen from their front: normals, tangents and texture coordinates are made for that
    /// side. Goes with RenderSettings::front_face; render() and render_picture() set it by that.
    bool clockwise_fronts = false;
    Bump bump = Bump::automatic;  ///< of materials that name no technique: which maps act, and so must have a place
    Subdivision subdivision{};    ///< of meshes that say nothing of their own; before displacement
    Displacement displacement{};
    bool tessellate = false;  ///< built-in shapes are their triangles in every engine: Mesh::shape is taken away
    bool operator==(const PrepareOptions&) const = default;
};

/// A scene that an engine can draw: every triangle mesh has finite unit normals, and tangents where a normal or height
/// map needs them. Says in the report what it replaced (zero or non-finite normals of the file, w = 0 tangents, ...).
Scene prepare_scene(Scene scene, const PrepareOptions& options, Context& context);

/// The scene as it stands, with nothing left in it that could move: nodes by Scene::pose, each placement of a mesh that
/// follows a skin or has morph targets as vertices of its own (glTF 2.0, sections 3.7.2.2 and 3.7.3). Positions, and the
/// normals and tangents that the meshes have: normals by the cofactor of the blended matrix, then unit. A skinned
/// placement stands in the world itself: its node has no parent and no transform, what hung from it stays where it was.
/// Skins, clips, targets and pose are gone. Other meshes share their arrays with the input.
/// Same bits for any number of threads. @throws Error bad_file: see validate(), over the memory budget
Scene posed_scene(const Scene& scene, Context& context);

/// Whether posed_scene() changes anything.
bool is_posable(const Scene& scene);

/// The rule of <rakelight/seams.h> over all drawn triangle meshes that have normals: placed in the world, skinned ones in
/// bind pose. Tangents and the offsets of morph targets turn with their normals; every other number keeps its bits, and
/// arrays in which nothing turns stay shared. Placements of one mesh that come out differently get a mesh of their own.
/// @param keep_instances  they go on sharing it, with the normals of the first; said in the report
/// @param seams  not null: what was done
Scene repair_seams(const Scene& scene, const SeamOptions& options, Context& context, SeamReport* seams = nullptr,
                   bool keep_instances = false);

/// The rule of <rakelight/matching_borders.h> over the same meshes: normals made to agree along borders that run along each
/// other without sharing vertices. Tangents and the offsets of morph targets turn with their normals; every other number keeps
/// its bits. Shared arrays and instances as above. Of a scene at rest: prepare_scene() does it for poses.
/// @param keep_instances  as above
/// @param borders  not null: what was done
Scene repair_borders(const Scene& scene, const MatchOptions& options, Context& context, MatchReport* borders = nullptr,
                     bool keep_instances = false);

}  // namespace rakelight
