// SPDX-License-Identifier: Apache-2.0
// The attributes that smooth_file() writes, as a scene.
#pragma once
#include <rakelight/tools/smooth_file.h>

namespace rakelight {

struct SmoothedScene {
    Scene scene;
    std::optional<SeamReport> seams{};     ///< where authored normals were kept
    std::uint64_t missing_made = 0;        ///< SmoothedFile::missing_made
    std::optional<MatchReport> borders{};  ///< where there was a border distance
};

/// Nodes and the first meshes in the order of `scene`, copies for placements of their own after them.
/// - AuthoredNormals::replaced, or no mesh has normals: new ones for all drawn triangle meshes, and tangents by the
///   choice (meshes that are not to have any have none).
/// - Else the normals and tangents that exist are joined where meshes meet. Meshes without normals get both as above,
///   at borders those of authors (SmoothRequest::only_missing). The choice `always` makes the tangents that are missing
///   (MikkTSpace), `never` removes all.
///
/// With a border distance all of these normals are then made to agree along borders that match; those of authors stay
/// flat where they are (MatchOptions::keep_flat).
SmoothedScene smooth_for_file(const Scene& scene, const SmoothFileOptions& options, Context& context);

}  // namespace rakelight
