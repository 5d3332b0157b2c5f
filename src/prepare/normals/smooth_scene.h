// SPDX-License-Identifier: Apache-2.0
// Options of smooth_scene(): what to compute for which meshes.
#pragma once
#include <optional>

#include <rakelight/geometry/attributes.h>
#include <rakelight/scene/scene.h>

#include "prepare/generated_attributes.h"
#include "prepare/normals/tangent_coordinates.h"

namespace rakelight {

struct SmoothRequest {
    AttributeOptions attributes;  ///< `tangents` is overridden by TangentNeed
    TangentNeed tangents = TangentNeed::where_needed;
    /// Keep normals that exist, and make those that are missing (NormalGaps): at borders as the kept ones are.
    bool only_missing = false;
    bool groups = true;  ///< use smoothing groups of the file; with `source` by normal_rule()
    /// Set: only meshes whose normal_rule() has attributes.scope. Crease angles of meshes count in any case.
    std::optional<NormalSource> source;
    bool every_scope = false;     ///< with `source`: all meshes, over attributes.scope
    bool bitangents = false;      ///< of the published modes: stored as Mesh::bitangents of static meshes
    bool keep_instances = false;  ///< instances share the first one's mesh even if their neighbors differ; reported
    /// Not null: gets the data of animated meshes for recomputation; morph targets then get no normals.
    std::vector<GeneratedAttributes>* made = nullptr;
    TangentMode kept_tangents =
        TangentMode::mikktspace;  ///< for add_missing_tangents(), overrides attributes.tangent_mode
};

/// New normals (and tangents by the need) for the drawn triangle meshes. The scene must be valid.
Scene smooth_meshes(Scene scene, const SmoothRequest& request, Context& context);

/// Tangents for drawn meshes with normals but without tangents; normals are kept. Each mesh separately, so that
/// instances stay shared; published modes over everything at a place in world space, for all meshes.
Scene add_missing_tangents(Scene scene, const SmoothRequest& request, Context& context);

/// Normals and tangents of a valid scene by <rakelight/geometry/attributes.h> over the whole scene.
struct SmoothSceneOptions {
    AttributeOptions attributes;
    bool only_missing = false;  ///< keep existing normals; compute the others
    /// Overrides attributes.tangent_mode for all meshes. Absent: that mode for computed normals, MikkTSpace for kept
    /// ones.
    std::optional<TangentMode> tangents;
};
Scene smooth_scene(const Scene& scene, const SmoothSceneOptions& options, Context& context);

}  // namespace rakelight
