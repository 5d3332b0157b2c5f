// SPDX-License-Identifier: Apache-2.0
// Between prepare_scene and smooth_scene: what to compute for which meshes.
#pragma once
#include <optional>

#include <rakelight/attributes.h>
#include <rakelight/scene.h>

#include "prepare/generated_attributes.h"

namespace rakelight {

/// Which meshes get tangents: those whose material has a normal or height texture, or all with texture coordinates.
enum class TangentNeed : std::uint8_t { none, where_needed, everywhere };

struct SmoothRequest {
    AttributeOptions attributes;  ///< `tangents` is overridden by TangentNeed
    TangentNeed tangents = TangentNeed::where_needed;
    bool only_missing = false;  ///< leave meshes alone that have normals
    bool groups = true;         ///< use smoothing groups of the file; with `source` by normal_rule()
    /// Set: only meshes whose normal_rule() by it has attributes.scope, by their own crease angles.
    std::optional<NormalSource> source;
    bool every_scope = false;     ///< with `source`: all meshes, over attributes.scope
    bool bitangents = false;      ///< of the published modes: kept as Mesh::bitangents of meshes that do not move
    bool keep_instances = false;  ///< instances share the first one's mesh even if their neighbors differ; reported
    /// Not null: what is made of meshes that move is kept here, to be made again; morph targets get no normals then.
    std::vector<GeneratedAttributes>* made = nullptr;
    TangentMode kept_tangents =
        TangentMode::mikktspace;  ///< of add_missing_tangents(), in place of attributes.tangent_mode
};

/// The coordinate set on which a mesh's tangents are to be made: that of the normal texture, else of the height texture, else
/// (need `everywhere`) the first that is there. `none`: no tangents, or no such coordinates.
std::uint32_t tangent_set(const Scene& scene, const Mesh& mesh, TangentNeed need);

/// New normals (and tangents by the need) for the drawn triangle meshes. The scene must be valid.
Scene smooth_meshes(Scene scene, const SmoothRequest& request, Context& context);

/// Tangents, by the need, for drawn meshes that have normals but no tangents; normals stay. Each mesh by itself, so that instances
/// stay shared; published ones over everything at a place in the world, for all meshes by the need.
Scene add_missing_tangents(Scene scene, const SmoothRequest& request, Context& context);

}  // namespace rakelight
