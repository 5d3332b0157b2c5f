// SPDX-License-Identifier: Apache-2.0
// The rule of <rakelight/matching_borders.h> over a scene: which placements match, once; where they turn, in any pose.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <rakelight/matching_borders.h>
#include <rakelight/scene.h>

#include "prepare/variants.h"

namespace rakelight {

struct BorderRequest {
    MatchOptions options{};
    /// Set: meshes take part by their normal_rule(), in sets by the scope over which they are smoothed, by their own crease
    /// angles, and `keep_flat` is for the sets in which some mesh joins seams. Unset: all, by `options`.
    std::optional<NormalSource> source{};
    bool keep_instances = false;  ///< instances share the first one's mesh even if their neighbors differ; reported
};

/// Placements of one scope, and which of their borders match.
struct BoundBorders {
    BorderMatch match;
    std::vector<Instance> instances;  ///< as match_borders() was given them
    bool moves = false;               ///< some follow a skin or have morph targets
};

/// What became of all borders of a scene.
struct BorderOutcome {
    MatchReport report;
    bool takes_part = false;  ///< some mesh does
};

/// Of the drawn triangle meshes that have normals, skinned ones in bind pose; the scene must be valid. Tangents and the
/// offsets of morph targets turn along.
/// @param moving  not null: sets that move are put there and not joined, but counted as if they were
Scene join_borders(Scene scene, const BorderRequest& request, BorderOutcome& outcome, Context& context,
                   std::vector<BoundBorders>* moving = nullptr);

/// One set: the current normals of the matched scene, or of its posed_scene().
Scene join_borders(Scene scene, const BoundBorders& borders, bool keep_instances, MatchReport& report,
                   Context& context);

/// Meshes whose own normals `automatic` keeps ask for `seams` from now on.
void join_kept_normals(Scene& scene);

/// Adds remarks on the results, and warnings if nothing matched.
void report_borders(const Scene& scene, const BorderRequest& request, const BorderOutcome& outcome, Report& report);

/// For people: "31 border vertices follow 12 leading ones; 40 normals turn (at most 8.5 degrees, 2.1 on average)".
std::string describe(const MatchReport& borders);

}  // namespace rakelight
