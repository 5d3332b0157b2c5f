// SPDX-License-Identifier: Apache-2.0
#include "geometry/fits/place_faces.h"

#include <algorithm>

#include "geometry/input/face_vote.h"

namespace rakelight::geometry {

PlaceFaces place_faces(const GroupRings& rings, std::uint32_t group) {
    PlaceFaces out;
    dvec3 sum;
    for (const std::uint32_t corner : rings.corners[group]) {
        if (!rings.is_face(corner / 3)) continue;
        sum += rings.normal(corner / 3) * double(rings.faces[corner / 3].area);
        ++out.faces;
    }
    out.by_area = direction_of(sum).unit;
    for (const std::uint32_t corner : rings.corners[group])
        if (rings.is_face(corner / 3))
            out.least_cosine = std::min(out.least_cosine, dot(rings.normal(corner / 3), out.by_area));
    return out;
}

dvec3 normal_by_angle(const GroupRings& rings, std::uint32_t group, dvec3 otherwise) {
    const dvec3 at = rings.places[group];
    dvec3 sum;
    for (const std::uint32_t corner : rings.corners[group]) {
        if (!rings.is_face(corner / 3)) continue;
        const dvec3 a = rings.places[rings.next(corner)] - at, b = rings.places[rings.previous(corner)] - at;
        sum += rings.normal(corner / 3) * corner_angle(2 * double(rings.faces[corner / 3].area), dot(a, b));
    }
    const Direction d = direction_of(sum);
    return d.length > 0 ? d.unit : otherwise;
}

}  // namespace rakelight::geometry
