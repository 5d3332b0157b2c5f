// SPDX-License-Identifier: Apache-2.0
#include "geometry/group_planes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/face_vote.h"
#include "geometry/union_find.h"

namespace rakelight::geometry {
namespace {

constexpr double most_bend_rad = radians(0.02), most_slack_rad = 0.01;

using FacePair = std::pair<std::uint32_t, std::uint32_t>;

class PlaneSearch {
public:
    PlaneSearch(const GroupRings& rings, const Topology& topology, const AttributeInput& input)
        : rings_(rings), topology_(topology), input_(input) {}

    /// Neighboring faces of one plane, of all groups of a range.
    std::vector<FacePair> pairs(std::size_t first, std::size_t last) const {
        std::vector<FacePair> out, memory;
        for_each_group(topology_, first, last, [&](std::uint32_t g) { add_pairs(g, memory, out); });
        return out;
    }

private:
    /// Pairs of faces that share an edge from the group to one of a higher number, once each.
    void add_pairs(std::uint32_t group, std::vector<FacePair>& memory, std::vector<FacePair>& out) const {
        memory.clear();
        for (const std::uint32_t corner : rings_.corners[group]) {
            if (!rings_.is_face(corner / 3)) continue;
            for (const std::uint32_t other : {rings_.next(corner), rings_.previous(corner)})
                if (other > group) memory.emplace_back(other, corner / 3);
        }
        if (memory.size() < 2) return;
        std::sort(memory.begin(), memory.end());
        for (std::size_t i = 0; i + 1 < memory.size(); ++i)
            if (memory[i].first == memory[i + 1].first && are_flat(memory[i].second, memory[i + 1].second))
                out.emplace_back(memory[i].second, memory[i + 1].second);
    }

    bool are_flat(std::uint32_t a, std::uint32_t b) const {
        const dvec3 n = rings_.normal(a), o = rings_.normal(b), across = cross(n, o);
        constexpr double most = most_bend_rad + 2 * most_slack_rad;
        if (!(dot(n, o) > 0 && dot(across, across) < most * most)) return false;
        const double bend = length(across);
        return bend < most_bend_rad || bend < most_bend_rad + slack_rad(a) + slack_rad(b);
    }

    /// [rad] by how much rounding to float may turn the normal of a face.
    double slack_rad(std::uint32_t triangle) const {
        const std::uint32_t m = input_.mesh_of_triangle(triangle);
        const AttributeMesh& mesh = input_.meshes[m];
        const std::uint32_t* index = mesh.indices.data() + 3 * std::size_t(triangle - input_.triangle_base[m]);
        const FaceCorners face = face_corners(mesh, index);
        float reach = 0;
        for (int k = 0; k < 3; ++k) {
            const vec3 p = mesh.positions[index[k]];
            reach = std::max({reach, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
        }
        const double longest = std::max({length(face.e1), length(face.e2), length(face.e2 - face.e1)}),
                     height = length(cross(face.e1, face.e2)) / longest;
        return height > 0 ? std::min(0x1p-23 * double(reach) / height, most_slack_rad) : 0;
    }

    const GroupRings& rings_;
    const Topology& topology_;
    const AttributeInput& input_;
};

double area_of(const GroupRings& rings, std::uint32_t triangle) {
    const std::uint32_t* group = rings.group_of_corner.data() + 3 * std::size_t(triangle);
    const dvec3 p = rings.places[group[0]];
    return rings.is_face(triangle) ? 0.5 * length(cross(rings.places[group[1]] - p, rings.places[group[2]] - p)) : 0;
}

}  // namespace

FacePlanes face_planes(const GroupRings& rings, const Topology& topology, const AttributeInput& input,
                       Context& context) {
    const std::size_t count = topology.group.size(), step = vertices_per_chunk, faces = input.triangle_count();
    context.memory().check(faces * (sizeof(double) + sizeof(FacePair) + 8ull), "planes of triangles");
    FacePlanes out{std::vector<std::uint32_t>(faces), std::vector<double>(faces)};
    std::vector<std::vector<FacePair>> pairs((count + step - 1) / step);
    const PlaneSearch search(rings, topology, input);
    context.parallel_for(pairs.size(),
                         [&](std::size_t c) { pairs[c] = search.pairs(c * step, std::min(count, (c + 1) * step)); });
    UnionFind sets;
    sets.reset(faces);
    for (std::vector<FacePair>& some : pairs) {
        for (const auto& [a, b] : some) sets.join(a, b);
        some = {};
    }
    context.parallel_for((faces + step - 1) / step, [&](std::size_t c) {
        for (std::size_t t = c * step; t < std::min(faces, (c + 1) * step); ++t)
            out.area[t] = area_of(rings, std::uint32_t(t));
    });
    for (std::uint32_t t = 0; t < faces; ++t) {
        const std::uint32_t plane = sets.root(t);
        out.plane_of[t] = FacePlanes::alone;
        if (plane == t) continue;
        out.area[plane] += out.area[t];
        out.plane_of[t] = out.plane_of[plane] = plane;
    }
    return out;
}

PlanesAtPlace planes_at(const GroupRings& rings, const FacePlanes& planes, std::uint32_t group,
                        std::vector<std::uint32_t>& memory) {
    PlanesAtPlace out;
    memory.clear();
    double all = 0, planar = 0, largest = -1;
    for (const std::uint32_t corner : rings.corners[group]) {
        if (!rings.is_face(corner / 3)) continue;
        const std::uint32_t plane = planes.plane_of[corner / 3];
        if (plane != FacePlanes::alone)
            memory.push_back(plane);
        else
            all += planes.area[corner / 3], largest = std::max(largest, planes.area[corner / 3]);
    }
    if (memory.empty()) return out;
    const bool has_single = all > 0;
    std::sort(memory.begin(), memory.end());
    memory.erase(std::unique(memory.begin(), memory.end()), memory.end());
    std::uint32_t ruling = FacePlanes::alone;
    for (const std::uint32_t plane : memory) {
        all += planes.area[plane], planar += planes.area[plane];
        if (planes.area[plane] > largest) largest = planes.area[plane], ruling = plane;
    }
    if (!(all > 0)) return out;
    out.share = largest / all, out.planar_share = planar / all;
    out.rules = ruling != FacePlanes::alone && (has_single || memory.size() >= 2);
    if (!out.rules) return out;
    for (const std::uint32_t corner : rings.corners[group])
        if (rings.is_face(corner / 3) && planes.plane_of[corner / 3] == ruling) out.normal += rings.normal(corner / 3);
    out.normal = normalize_or(out.normal, {});
    return out;
}

}  // namespace rakelight::geometry
