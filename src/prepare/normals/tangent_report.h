// SPDX-License-Identifier: Apache-2.0
// Remarks on tangents: deviation from orthogonality, and inverted maps.
#pragma once
#include <rakelight/base/context.h>
#include <rakelight/geometry/attributes.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// A note about one mesh. [degrees]
void report_orthogonality(const Scene& scene, std::uint32_t mesh, double largest_deg, double mean_deg, Report& report);

/// Triangles with a backwards map, over all instances with computed tangents.
struct InvertedMaps {
    std::uint64_t triangles = 0, of = 0;
    std::uint32_t first_mesh = no_index;  ///< the first mesh with one
};
/// Adds a warning if there are any.
/// @param mode of the tangents
void report_inverted(const Scene& scene, const InvertedMaps& inverted, TangentMode mode, Report& report);

/// Measures the file's tangents of drawn triangle meshes in object space, and adds notes.
void report_kept_tangents(const Scene& scene, Report& report);

}  // namespace rakelight
