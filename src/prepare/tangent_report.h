// SPDX-License-Identifier: Apache-2.0
// Said in the report: how far tangents were from perpendicular to their normals.
#pragma once
#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

/// A note about one mesh. [degrees]
void report_orthogonality(const Scene& scene, std::uint32_t mesh, double largest_deg, double mean_deg, Report& report);

/// Measures the tangents that the file gave to drawn triangle meshes, in their own spaces, and notes them.
void report_kept_tangents(const Scene& scene, Report& report);

}  // namespace rakelight
