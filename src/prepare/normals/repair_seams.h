// SPDX-License-Identifier: Apache-2.0
// Applies join_seams() of <rakelight/geometry/seams.h> to a scene.
#pragma once
#include <optional>
#include <string>

#include <rakelight/geometry/seams.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

struct SeamRequest {
    SeamOptions options{};
    /// Set: only meshes whose normal_rule() joins seams. Absent: all. Crease angles of meshes count in any case.
    std::optional<NormalSource> source{};
    bool keep_instances = false;  ///< instances share the first one's mesh even if their neighbors differ; reported
};

/// Joins the normals of drawn triangle meshes where they meet; the scene must be valid. Tangents and offsets of morph
/// targets rotate with the normals.
Scene join_seams(Scene scene, const SeamRequest& request, SeamReport& seams, Context& context);

/// Readable text: "12 of 340 authored normals turn (at most 8.5 degrees, 2.1 on average)", and how many flat pairs
/// stay.
/// @param missing_made  normals that were made beside
std::string describe(const SeamReport& seams, std::uint64_t missing_made = 0);

}  // namespace rakelight
