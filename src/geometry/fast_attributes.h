// SPDX-License-Identifier: Apache-2.0
// The fast path for crease angle pi, no smoothing groups and one angle-preserving matrix for all meshes. Votes are
// summed in float inside each mesh, and only vertices are welded. Places that float could decide differently from
// double are left to the general path.
#pragma once
#include "geometry/fast_state.h"

namespace rakelight::geometry {

/// The general path (attributes.cpp): every option, in double.
/// @param wanted  [vertices] 0: what comes out at its place is not needed; empty: all are
std::vector<MeshAttributes> general_attributes(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                               std::span<const std::uint8_t> wanted, GeneralScratch& scratch,
                                               Context& context);
std::vector<MeshAttributes> general_attributes(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                               Context& context);

/// Whether the fast path covers these options and matrices.
bool takes_fast_path(std::span<const AttributeMesh> meshes, const AttributeOptions& options);

/// The general path's result for one mesh, in the form of the buffers.
SplitAttributes split_from(const AttributeMesh& mesh, const MeshAttributes& result, const AttributeBuffers& out);

/// @param out  [meshes] large enough: checked by the caller
/// @throws Error as compute_attributes()
std::vector<SplitAttributes> fast_attributes(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                             std::span<const AttributeBuffers> out, FastScratch& scratch,
                                             Context& context);

/// The same with arrays as result.
std::vector<MeshAttributes> fast_attributes(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                            Context& context);

}  // namespace rakelight::geometry
