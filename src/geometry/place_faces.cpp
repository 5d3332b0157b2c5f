// SPDX-License-Identifier: Apache-2.0
#include "geometry/place_faces.h"

#include <algorithm>
#include <cmath>

#include "geometry/face_vote.h"

namespace rakelight::geometry {
namespace {

/// Calls body(face, edge to the next group, edge to the one before).
template <class Body>
void for_each_face(const GroupRings& rings, std::uint32_t group, const Body& body) {
    const dvec3 at = rings.places[group];
    for (const std::uint32_t corner : rings.corners[group])
        if (rings.is_face(corner / 3))
            body(corner / 3, rings.places[rings.next(corner)] - at, rings.places[rings.previous(corner)] - at);
}

}  // namespace

PlaceFaces place_faces(const GroupRings& rings, std::uint32_t group) {
    PlaceFaces out;
    dvec3 sum;
    for_each_face(rings, group, [&](std::uint32_t face, dvec3 a, dvec3 b) {
        const dvec3 n = rings.normal(face);
        const double twice = dot(cross(a, b), n);  // mirroring matrices turn the cross product, not the normal
        sum += n * std::fabs(twice);
        ++out.faces;
    });
    out.by_area = direction_of(sum).unit;
    for (const std::uint32_t corner : rings.corners[group])
        if (rings.is_face(corner / 3))
            out.least_cosine = std::min(out.least_cosine, dot(rings.normal(corner / 3), out.by_area));
    return out;
}

dvec3 normal_by_angle(const GroupRings& rings, std::uint32_t group, dvec3 otherwise) {
    dvec3 sum;
    for_each_face(rings, group, [&](std::uint32_t face, dvec3 a, dvec3 b) {
        sum += rings.normal(face) * corner_angle(length(cross(a, b)), dot(a, b));
    });
    const Direction d = direction_of(sum);
    return d.length > 0 ? d.unit : otherwise;
}

double mean_edge(const GroupRings& rings, std::uint32_t group) {
    double squares = 0;
    for (const std::uint32_t u : rings.ring(group)) {
        const dvec3 d = rings.places[u] - rings.places[group];
        squares += dot(d, d);
    }
    return std::sqrt(squares / std::max<double>(rings.ring_size[group], 1));
}

}  // namespace rakelight::geometry
