// SPDX-License-Identifier: Apache-2.0
#include "geometry/creases/meant_planes.h"

#include <algorithm>
#include <cmath>

namespace rakelight::geometry {
namespace {

constexpr double least_planar = 0.1;      // of the area
constexpr double least_known = 0.25;      // of the area
constexpr float near_rounding = 1.f / 3;  // of what rounding may turn at most: most bends within a plane are smaller
constexpr float beyond_rounding = 2;      // larger bends say nothing: they are those of the shape

/// What a surface shows.
struct Evidence {
    struct Bends {
        std::uint32_t near = 0, beyond = 0;
        void add(float ratio) {
            if (ratio <= beyond_rounding) ++(ratio <= near_rounding ? near : beyond);
        }
    };
    double area = 0, planar = 0, known = 0;  // [m^2]
    Bends edges, faces;

    bool shows_planes() const {
        const bool is_chance = edges.beyond > edges.near && 2 * faces.beyond > faces.near;
        return planar >= least_planar * area && known >= least_known * area && !is_chance;
    }
};

/// [T] of surfaces
std::vector<Evidence> gather_evidence(const BentEdges& bent, const std::vector<std::uint32_t>& faces_of_plane) {
    constexpr float unknown = 1e30f;
    const std::size_t count = bent.plane_of.size();
    std::vector<Evidence> out(count);
    std::vector<float> least(count, unknown);  // bend of a face, as a share of what rounding may bend
    for (const BentEdge& e : bent.edges) {
        if (e.rounding_deg > e.slack_deg) continue;
        const float ratio = std::fabs(e.bend_deg) / e.slack_deg;
        out[bent.surface_of[e.face(0)]].edges.add(ratio);
        for (const int side : {0, 1}) least[e.face(side)] = std::min(least[e.face(side)], ratio);
    }
    for (std::size_t t = 0; t < count; ++t) {
        Evidence& surface = out[bent.surface_of[t]];
        const double area = double(bent.area[t]);
        surface.area += area;
        if (faces_of_plane[bent.plane_of[t]] >= 2) surface.planar += area;
        if (least[t] < unknown) surface.known += area;
        surface.faces.add(least[t]);
    }
    return out;
}

/// [T] of planes: pairs of triangles among single ones. Pairs found in one round are single triangles in the next.
std::vector<std::uint8_t> find_chance_pairs(const BentEdges& bent, const std::vector<std::uint32_t>& faces_of_plane,
                                            const std::vector<std::uint32_t>& faces_of_surface, double hard_deg) {
    constexpr int rounds = 2;
    struct Neighbors {
        std::uint32_t single = 0, planes = 0;
    };
    std::vector<std::uint8_t> out(bent.plane_of.size(), 0);
    for (int round = 0; round < rounds; ++round) {
        std::vector<Neighbors> meets(out.size());
        for (const BentEdge& e : bent.edges) {
            const std::uint32_t planes[2] = {bent.plane(e, 0), bent.plane(e, 1)};
            if (planes[0] == planes[1] || std::fabs(double(e.bend_deg)) >= hard_deg) continue;
            for (const int side : {0, 1}) {
                const std::uint32_t other = planes[1 - side];
                const bool is_plane = faces_of_plane[other] >= 2 && out[other] == 0;
                ++(is_plane ? meets[planes[side]].planes : meets[planes[side]].single);
            }
        }
        for (std::size_t t = 0; t < out.size(); ++t) {
            const bool is_small = faces_of_surface[bent.surface_of[t]] <= small_surface;
            const std::uint32_t most = is_small ? std::min(meets[t].single, 1u) : meets[t].single;
            out[t] = faces_of_plane[t] == 2 && meets[t].planes < most;
        }
    }
    return out;
}

}  // namespace

MeantPlanes find_meant_planes(const BentEdges& bent, double hard_deg) {
    const std::size_t count = bent.plane_of.size();
    MeantPlanes out{std::vector<std::uint32_t>(count, 0), std::vector<std::uint8_t>(count, 0),
                    std::vector<std::uint8_t>(count, 0)};
    std::vector<std::uint32_t> faces_of_plane(count, 0);
    for (std::size_t t = 0; t < count; ++t)
        ++faces_of_plane[bent.plane_of[t]], ++out.faces_of_surface[bent.surface_of[t]];
    const std::vector<Evidence> evidence = gather_evidence(bent, faces_of_plane);
    const std::vector<std::uint8_t> is_chance = find_chance_pairs(bent, faces_of_plane, out.faces_of_surface, hard_deg);
    for (std::size_t t = 0; t < count; ++t) out.has_planes[t] = evidence[t].shows_planes();
    for (std::size_t t = 0; t < count; ++t)
        out.is_meant[t] = faces_of_plane[t] >= 2 && is_chance[t] == 0 && out.has_planes[bent.surface_of[t]] != 0;
    return out;
}

}  // namespace rakelight::geometry
