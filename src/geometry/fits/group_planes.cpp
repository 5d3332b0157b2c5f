// SPDX-License-Identifier: Apache-2.0
#include "geometry/fits/group_planes.h"

#include <algorithm>
#include <utility>

#include "geometry/input/union_find.h"

namespace rakelight::geometry {
namespace {

constexpr double most_bend_rad = radians(0.02);

using FacePair = std::pair<std::uint32_t, std::uint32_t>;

bool are_flat(const GroupFace& a, const GroupFace& b) {
    const vec3 across = cross(a.normal, b.normal);
    const float most = float(most_bend_rad) + a.slack_rad + b.slack_rad;
    return dot(across, across) < most * most && dot(a.normal, b.normal) > 0;
}

/// Appends the pairs of flat faces that share an edge from the group to one of a higher number, once each. A face that
/// is turned around has no neighbor in its plane.
class FlatPairs {
public:
    explicit FlatPairs(const GroupRings& rings) : rings_(rings) {}

    void add(std::uint32_t group, std::vector<FacePair>& out) {
        ahead_.clear(), behind_.clear();
        for (const std::uint32_t corner : rings_.corners[group]) {
            if (!rings_.is_face(corner / 3)) continue;
            if (const std::uint32_t other = rings_.next(corner); other > group) ahead_.emplace_back(other, corner / 3);
            if (const std::uint32_t other = rings_.previous(corner); other > group)
                behind_.emplace_back(other, corner / 3);
        }
        if (ahead_.size() > few) {
            std::sort(behind_.begin(), behind_.end());
            for (const FacePair& a : ahead_) join_any(a, out);
            return;
        }
        for (const FacePair& a : ahead_)
            for (const FacePair& b : behind_)
                if (a.first == b.first) join(a, b, out);
    }

private:
    static constexpr std::size_t few = 16, most_at_edge = 64;  // an edge of more faces is in no plane

    void join_any(const FacePair& a, std::vector<FacePair>& out) const {
        const auto first = std::lower_bound(behind_.begin(), behind_.end(), FacePair{a.first, 0});
        const auto last = std::upper_bound(first, behind_.end(), FacePair{a.first, 0xffffffffu});
        if (last - first > std::ptrdiff_t(most_at_edge)) return;
        for (auto b = first; b != last; ++b)
            if (join(a, *b, out)) break;
    }

    bool join(const FacePair& a, const FacePair& b, std::vector<FacePair>& out) const {
        if (!are_flat(rings_.faces[a.second], rings_.faces[b.second])) return false;
        out.emplace_back(a.second, b.second);
        return true;
    }

    const GroupRings& rings_;
    std::vector<FacePair> ahead_, behind_;  // the group at the edge's other end, and the face
};

/// [chunks of groups]
std::vector<std::vector<FacePair>> flat_pairs(const GroupRings& rings, const Topology& topology, Context& context) {
    const std::size_t count = topology.group.size(), step = vertices_per_chunk;
    std::vector<std::vector<FacePair>> pairs((count + step - 1) / step);
    context.parallel_for(pairs.size(), [&](std::size_t c) {
        FlatPairs flat(rings);
        for_each_group(topology, c * step, std::min(count, (c + 1) * step),
                       [&](std::uint32_t g) { flat.add(g, pairs[c]); });
    });
    return pairs;
}

bool is_known(const GroupRings& rings, std::uint32_t face, std::span<const std::uint8_t> known) {
    const std::uint32_t* const group = rings.group_of_corner.data() + 3 * std::size_t(face);
    return known.empty() || (known[group[0]] != 0 && known[group[1]] != 0 && known[group[2]] != 0);
}

}  // namespace

bool FacePlanes::has_open(std::span<const std::uint32_t> corners) const {
    return !empty() && std::any_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
        const std::uint32_t plane = plane_of[corner / 3];
        return plane != alone && is_open[plane] != 0;
    });
}

FacePlanes face_planes(const GroupRings& rings, const Topology& topology, std::size_t faces,
                       std::span<const std::uint8_t> known, GeneralScratch& scratch, Context& context) {
    const std::vector<std::vector<FacePair>> pairs = flat_pairs(rings, topology, context);
    std::size_t count = 0;
    for (const std::vector<FacePair>& some : pairs) count += some.size();
    FacePlanes out;
    if (count == 0) return out;
    out.charge = {context.memory(), faces * sizeof(std::uint32_t) + count * (sizeof(FacePair) + 24),
                  "planes of triangles"};
    out.plane_of = scratch.take<std::uint32_t>(faces);
    std::fill(out.plane_of.data(), out.plane_of.data() + faces, FacePlanes::alone);
    for (const std::vector<FacePair>& some : pairs)
        for (const auto& [a, b] : some) out.plane_of[a] = out.plane_of[b] = 0;
    std::vector<std::uint32_t> flat;  // ascending; plane_of has their numbers until these are joined
    for (std::uint32_t t = 0; t < faces; ++t) {
        if (out.plane_of[t] == FacePlanes::alone) continue;
        out.plane_of[t] = std::uint32_t(flat.size());
        flat.push_back(t);
    }
    UnionFind sets;
    sets.reset(flat.size());
    for (const std::vector<FacePair>& some : pairs)
        for (const auto& [a, b] : some) sets.join(out.plane_of[a], out.plane_of[b]);
    out.area.resize(flat.size());
    out.is_open.resize(flat.size());
    for (std::uint32_t i = 0; i < flat.size(); ++i) {
        const std::uint32_t plane = sets.root(i);
        out.plane_of[flat[i]] = plane;
        out.area[plane] += double(rings.faces[flat[i]].area);
        if (!is_known(rings, flat[i], known)) out.is_open[plane] = 1;
    }
    return out;
}

PlanesAtPlace planes_at(const GroupRings& rings, const FacePlanes& planes, std::uint32_t group,
                        std::vector<std::uint32_t>& memory) {
    PlanesAtPlace out;
    if (planes.empty()) return out;
    memory.clear();
    double all = 0, planar = 0, largest = -1;
    for (const std::uint32_t corner : rings.corners[group]) {
        if (!rings.is_face(corner / 3)) continue;
        const std::uint32_t plane = planes.plane_of[corner / 3];
        if (plane != FacePlanes::alone)
            memory.push_back(plane);
        else
            all += double(rings.faces[corner / 3].area),
                largest = std::max(largest, double(rings.faces[corner / 3].area));
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
