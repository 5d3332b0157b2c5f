// SPDX-License-Identifier: Apache-2.0
#include "geometry/fits/group_planes.h"

#include <algorithm>
#include <utility>

#include "geometry/input/union_find.h"

namespace rakelight::geometry {
namespace {

bool is_known(const GroupRings& rings, std::uint32_t face, std::span<const std::uint8_t> known) {
    const std::uint32_t* const group = rings.group_of_corner.data() + 3 * std::size_t(face);
    return known.empty() || (known[group[0]] != 0 && known[group[1]] != 0 && known[group[2]] != 0);
}

}  // namespace

bool FacePlanes::has_open() const {
    return std::any_of(is_open.begin(), is_open.end(), [](std::uint8_t open) { return open != 0; });
}
bool FacePlanes::has_open(std::span<const std::uint32_t> corners) const {
    return !empty() && std::any_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
        const std::uint32_t plane = plane_of[corner / 3];
        return plane != alone && is_open[plane] != 0;
    });
}

FacePlanes face_planes(const GroupRings& rings, std::span<const std::vector<Spokes::FacePair>> pairs, std::size_t faces,
                       std::span<const std::uint8_t> known, GeneralScratch& scratch, Context& context) {
    std::size_t count = 0;
    for (const auto& some : pairs) count += some.size();
    FacePlanes out;
    if (count == 0) return out;
    out.charge = {context.memory(), faces * sizeof(std::uint32_t) + count * (sizeof(Spokes::FacePair) + 24),
                  "planes of triangles"};
    out.plane_of = scratch.take<std::uint32_t>(faces);
    std::fill(out.plane_of.data(), out.plane_of.data() + faces, FacePlanes::alone);
    for (const auto& some : pairs)
        for (const auto& [a, b] : some) out.plane_of[a] = out.plane_of[b] = 0;
    std::vector<std::uint32_t> flat;  // ascending; plane_of has their numbers until these are joined
    for (std::uint32_t t = 0; t < faces; ++t) {
        if (out.plane_of[t] == FacePlanes::alone) continue;
        out.plane_of[t] = std::uint32_t(flat.size());
        flat.push_back(t);
    }
    UnionFind sets;
    sets.reset(flat.size());
    for (const auto& some : pairs)
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
