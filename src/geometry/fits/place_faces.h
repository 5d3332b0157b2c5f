// SPDX-License-Identifier: Apache-2.0
// What the faces of a corner group say of its normal.
#pragma once
#include "geometry/fits/spokes.h"

namespace rakelight::geometry {

struct PlaceFaces {
    vec3 by_area;            ///< unit; zero: no faces, or they cancel
    float least_cosine = 1;  ///< of the faces' normals to by_area
};
PlaceFaces place_faces(const GroupRings& rings, const Spokes& spokes);

/// By the weight `angle`, unit.
dvec3 normal_by_angle(const GroupRings& rings, std::uint32_t group, dvec3 otherwise);

/// Whether the surface ends at a group: it has more neighbors than faces.
bool is_border(const GroupRings& rings, std::uint32_t group);

}  // namespace rakelight::geometry
