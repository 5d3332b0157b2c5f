// SPDX-License-Identifier: Apache-2.0
// Applies <rakelight/geometry/matching_borders.h> to a scene: matches instances once, computes normals for any pose.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <rakelight/geometry/matching_borders.h>
#include <rakelight/scene/scene.h>

#include "prepare/variants.h"

namespace rakelight {

struct BorderRequest {
    MatchOptions options{};
    /// Set: meshes match by their normal_rule(), in sets by smoothing scope and with their own crease angles;
    /// `keep_flat` applies to sets with a mesh that joins seams. Absent: all meshes, by `options`.
    std::optional<NormalSource> source{};
    bool keep_instances = false;  ///< instances share the first one's mesh even if their neighbors differ; reported
};

/// Instances of one scope with their matched borders.
struct BoundBorders {
    BorderMatch match;
    std::vector<Instance> instances;  ///< as given to match_borders()
    bool moves = false;               ///< some are skinned or morphed
};

/// Results over all borders of a scene.
struct BorderOutcome {
    MatchReport report;
    bool takes_part = false;  ///< any mesh was matched
};

/// For drawn triangle meshes with normals, skinned ones in bind pose; the scene must be valid. Tangents and offsets of
/// morph targets rotate with the normals.
/// @param moving not null: gets animated sets, which are not joined but counted
Scene join_borders(Scene scene, const BorderRequest& request, BorderOutcome& outcome, Context& context,
                   std::vector<BoundBorders>* moving = nullptr);

/// One set: the current normals of the matched scene, or of its posed_scene().
Scene join_borders(Scene scene, const BoundBorders& borders, bool keep_instances, MatchReport& report,
                   Context& context);

/// Meshes whose normals `automatic` keeps get `seams`.
void join_kept_normals(Scene& scene);

/// Adds remarks on the results, and warnings if nothing matched.
void report_borders(const Scene& scene, const BorderRequest& request, const BorderOutcome& outcome, Report& report);

/// Readable text: "31 border vertices follow 12 leading ones; 40 normals turn (at most 8.5 degrees, 2.1 on average)".
std::string describe(const MatchReport& borders);

}  // namespace rakelight
