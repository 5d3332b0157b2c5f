// SPDX-License-Identifier: Apache-2.0
// Said in the report: how far tangents were from perpendicular to their normals, and which maps they invert.
#pragma once
#include <rakelight/attributes.h>
#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

/// A note about one mesh. [degrees]
void report_orthogonality(const Scene& scene, std::uint32_t mesh, double largest_deg, double mean_deg, Report& report);

/// Triangles that show their map backwards, of all placed meshes whose tangents were made.
struct InvertedMaps {
    std::uint64_t triangles = 0, of = 0;
    std::uint32_t first_mesh = no_index;  ///< that has one
};
/// A warning where there are any. @param mode  that made the tangents
void report_inverted(const Scene& scene, const InvertedMaps& inverted, TangentMode mode, Report& report);

/// Measures the tangents that the file gave to drawn triangle meshes, in their own spaces, and notes them.
void report_kept_tangents(const Scene& scene, Report& report);

}  // namespace rakelight
