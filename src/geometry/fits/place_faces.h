// SPDX-License-Identifier: Apache-2.0
// What the faces of a corner group say of its normal.
#pragma once
#include "geometry/fits/group_rings.h"

namespace rakelight::geometry {

struct PlaceFaces {
    dvec3 by_area;            ///< unit; zero: no faces, or they cancel
    double least_cosine = 1;  ///< of the faces' normals to by_area
    std::uint32_t faces = 0;
};
PlaceFaces place_faces(const GroupRings& rings, std::uint32_t group);

/// By the weight `angle`, unit.
dvec3 normal_by_angle(const GroupRings& rings, std::uint32_t group, dvec3 otherwise);

/// Whether the surface ends at a group: it has more neighbors than faces.
inline bool is_border(const GroupRings& rings, std::uint32_t group, std::uint32_t faces) {
    return rings.ring_size[group] > faces;
}

}  // namespace rakelight::geometry
