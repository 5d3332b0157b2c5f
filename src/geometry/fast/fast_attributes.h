// SPDX-License-Identifier: Apache-2.0
// The fast path for one crease angle (or the rule, where all bends are small), no smoothing groups and one angle-preserving
// matrix for all meshes. Votes are summed in float inside each mesh, and only vertices are welded. Creases, and places that
// float could decide differently from double, are left to the general path.
#pragma once
#include "geometry/fast/fast_state.h"

namespace rakelight::geometry {

/// Whether the fast path covers these options and matrices.
bool takes_fast_path(std::span<const AttributeMesh> meshes, const AttributeOptions& options);

/// @param out  [meshes] large enough: checked by the caller
/// @throws Error as compute_attributes()
std::vector<SplitAttributes> fast_attributes(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                             std::span<const AttributeBuffers> out, FastScratch& scratch,
                                             Context& context);

/// The same with arrays as result.
std::vector<MeshAttributes> fast_attributes(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                            Context& context);

}  // namespace rakelight::geometry
