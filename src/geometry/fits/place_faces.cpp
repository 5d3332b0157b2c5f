// SPDX-License-Identifier: Apache-2.0
#include "geometry/fits/place_faces.h"

#include <algorithm>

#include "geometry/input/face_vote.h"

namespace rakelight::geometry {

PlaceFaces place_faces(const GroupRings& rings, const Spokes& spokes) {
    vec3 sum;
    for (std::uint32_t i = 0; i < spokes.count(); ++i) {
        const GroupFace& face = rings.faces[spokes.face(i)];
        sum += face.normal * face.area;
    }
    PlaceFaces out{.by_area = cast<float>(direction_of(cast<double>(sum)).unit)};
    for (std::uint32_t i = 0; i < spokes.count(); ++i)
        out.least_cosine = std::min(out.least_cosine, dot(rings.faces[spokes.face(i)].normal, out.by_area));
    return out;
}

bool is_border(const GroupRings& rings, std::uint32_t group) {
    std::uint32_t faces = 0;
    for (const std::uint32_t corner : rings.corners[group]) faces += rings.is_face(corner / 3) ? 1 : 0;
    return rings.ring_size[group] > faces;
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
