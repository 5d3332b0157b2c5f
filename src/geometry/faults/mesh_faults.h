// SPDX-License-Identifier: Apache-2.0
// Faults of single faces and vertices: unusable normals, faces without area, mirrored texture charts that meet
// mirrored.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/faults/place_classes.h"

namespace rakelight::geometry {

/// How far a normal's length may be from 1: what 8-bit quantization leaves.
constexpr double unit_length_slack = 0.01;

/// Of one object. Normals are those of AttributeMesh::normals, of vertices that a face uses.
struct ObjectFaults {
    std::uint64_t zero_normals = 0;
    std::uint64_t non_finite_normals = 0;
    std::uint64_t non_unit_normals = 0;  ///< neither of the two, but the length is off 1 by more than unit_length_slack
    std::uint64_t degenerate_faces = 0;  ///< zero area, or a corner that is not finite: no vote in any normal
    std::uint64_t mirrored_places = 0;   ///< places with faces of both texture handednesses
    std::uint64_t mirror_split_vertices = 0;  ///< vertices that faces of both use, so that their tangent must be split
};

/// O(n); `objects` is more than the largest AttributeMesh::object.
std::vector<ObjectFaults> count_faults(const PlacedMeshes& placed, std::uint32_t objects, const Context& context);

}  // namespace rakelight::geometry
