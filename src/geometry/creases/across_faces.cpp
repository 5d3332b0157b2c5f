// SPDX-License-Identifier: Apache-2.0
#include "geometry/creases/across_faces.h"

#include <cmath>

#include "geometry/creases/plane_widths.h"
#include "geometry/input/face_vote.h"

namespace rakelight::geometry {
namespace {

/// The same edge, seen from the other side.
int other_side(const BentEdge& edge, std::uint32_t corner) { return edge.corner[0] == corner ? 1 : 0; }

}  // namespace

Across across_plane(const BentEdges& bent, const AttributeInput& input, std::uint32_t edge, int side) {
    std::uint32_t corner = bent.edges[edge].corner[side];
    const FacePoints start = face_points(input, corner / 3);
    const dvec3 a = start.p[corner % 3], along = direction_of(start.p[(corner + 1) % 3] - a).unit,
                middle = (a + start.p[(corner + 1) % 3]) * 0.5;
    for (int n = 0; n < most_across; ++n) {
        const FacePoints face = face_points(input, corner / 3);
        const std::uint32_t first = corner % 3, apex = (first + 2) % 3;
        // The edge after this one, or the edge before it: whose ends lie on both sides of the way.
        const bool starts_behind = dot(face.p[first] - middle, along) < 0,
                   apex_behind = dot(face.p[apex] - middle, along) < 0;
        const std::uint32_t out = starts_behind == apex_behind ? corner_after(corner) : corner_before(corner),
                            next = bent.edge_of_corner[out];
        const dvec3 p = face.p[out % 3] - middle, q = face.p[(out + 1) % 3] - middle;
        const double u = dot(p, along), v = dot(q, along), share = u != v ? u / (u - v) : 0.5;
        if (next != no_edge && bent.plane(bent.edges[next], 0) == bent.plane(bent.edges[next], 1)) {
            corner = bent.edges[next].corner[other_side(bent.edges[next], out)];
            continue;
        }
        const bool is_parallel = std::fabs(dot(direction_of(q - p).unit, along)) >= parallel_edges;
        const dvec3 end = p + (q - p) * share;
        return {float(length(end - along * dot(end, along))), is_parallel ? next : no_edge,
                next == no_edge ? 0 : other_side(bent.edges[next], out)};
    }
    return {};
}

Across across_square(const BentEdges& bent, std::uint32_t edge, int side, double flat_deg, bool is_after) {
    const std::uint32_t corner = bent.edges[edge].corner[side],
                        through = is_after ? corner_after(corner) : corner_before(corner),
                        diagonal = bent.edge_of_corner[through];
    if (diagonal == no_edge || std::fabs(double(bent.edges[diagonal].bend_deg)) >= flat_deg) return {};
    const BentEdge& d = bent.edges[diagonal];
    const std::uint32_t other = d.corner[other_side(d, through)],
                        out = is_after != bent.is_turned(d) ? corner_before(other) : corner_after(other),
                        far = bent.edge_of_corner[out];
    return {0, far, far == no_edge ? 0 : other_side(bent.edges[far], out)};
}

}  // namespace rakelight::geometry
