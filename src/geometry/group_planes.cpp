// SPDX-License-Identifier: Apache-2.0
#include "geometry/group_planes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/face_vote.h"
#include "geometry/union_find.h"

namespace rakelight::geometry {
namespace {

constexpr double most_bend_rad = radians(0.02);

/// Areas [m^2] and the angles [rad] by which rounding to float may turn the normals.
struct FaceMeasures {
    std::vector<double> area;
    std::vector<float> slack_rad;
};
FaceMeasures measures_of(const AttributeInput& input, Context& context) {
    FaceMeasures out{std::vector<double>(input.triangle_count()), std::vector<float>(input.triangle_count())};
    const std::vector<Chunk> chunks = make_chunks(input.triangle_base, triangles_per_chunk);
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        for_each_range(chunks[c], input.triangle_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const AttributeMesh& mesh = input.meshes[m];
            for (std::uint32_t t = first; t < last; ++t) {
                const std::uint32_t* index = mesh.indices.data() + 3 * std::size_t(t);
                const FaceCorners face = face_corners(mesh, index);
                const std::uint32_t at = input.triangle_base[m] + t;
                out.area[at] = 0.5 * face_normal(input.placements[m], face).length;
                float reach = 0;
                for (int k = 0; k < 3; ++k) {
                    const vec3 p = mesh.positions[index[k]];
                    reach = std::max({reach, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
                }
                const double longest = std::max({length(face.e1), length(face.e2), length(face.e2 - face.e1)}),
                             height = length(cross(face.e1, face.e2)) / longest;
                out.slack_rad[at] = height > 0 ? float(std::min(0x1p-23 * double(reach) / height, 0.01)) : 0;
            }
        });
    });
    return out;
}

/// Pairs of faces that share an edge from a group to one of a higher number, once each.
template <class Body>
void for_each_edge(const GroupRings& rings, std::uint32_t group,
                   std::vector<std::pair<std::uint32_t, std::uint32_t>>& memory, const Body& body) {
    memory.clear();
    for (const std::uint32_t corner : rings.corners[group]) {
        const std::uint32_t t = corner / 3, k = corner % 3;
        if (!rings.is_face(t)) continue;
        for (const std::uint32_t other :
             {rings.group_of_corner[3 * t + (k + 1) % 3], rings.group_of_corner[3 * t + (k + 2) % 3]})
            if (other > group) memory.emplace_back(other, t);
    }
    std::sort(memory.begin(), memory.end());
    for (std::size_t i = 0; i + 1 < memory.size(); ++i)
        if (memory[i].first == memory[i + 1].first) body(memory[i].second, memory[i + 1].second);
}

using FacePair = std::pair<std::uint32_t, std::uint32_t>;

/// Neighboring faces of one plane, of all groups of a chunk.
std::vector<FacePair> flat_pairs(const GroupRings& rings, const Topology& topology, const FaceMeasures& measures,
                                 std::size_t first, std::size_t last) {
    std::vector<FacePair> out, memory;
    for_each_group(topology, first, last, [&](std::uint32_t g) {
        for_each_edge(rings, g, memory, [&](std::uint32_t a, std::uint32_t b) {
            const double most = most_bend_rad + double(measures.slack_rad[a]) + double(measures.slack_rad[b]);
            const dvec3 n = rings.face_normals[a], o = rings.face_normals[b];
            if (dot(n, o) > 0 && length(cross(n, o)) < most) out.emplace_back(a, b);
        });
    });
    return out;
}

}  // namespace

FacePlanes face_planes(const GroupRings& rings, const Topology& topology, const AttributeInput& input,
                       Context& context) {
    const std::size_t count = topology.group.size(), step = vertices_per_chunk, faces = input.triangle_count();
    context.memory().check(faces * (sizeof(double) + sizeof(float) + sizeof(FacePair) + 20ull), "planes of triangles");
    const FaceMeasures measures = measures_of(input, context);
    std::vector<std::vector<FacePair>> pairs((count + step - 1) / step);
    context.parallel_for(pairs.size(), [&](std::size_t c) {
        pairs[c] = flat_pairs(rings, topology, measures, c * step, std::min(count, (c + 1) * step));
    });
    UnionFind sets;
    sets.reset(faces);
    for (const std::vector<FacePair>& some : pairs)
        for (const auto& [a, b] : some) sets.join(a, b);
    FacePlanes out{std::vector<std::uint32_t>(faces), std::vector<double>(faces, 0), std::vector<std::uint32_t>(faces)};
    for (std::uint32_t t = 0; t < faces; ++t) {
        const std::uint32_t plane = out.plane_of[t] = sets.root(t);
        out.area[plane] += measures.area[t];
        ++out.faces[plane];
    }
    return out;
}

PlanesAtPlace planes_at(const GroupRings& rings, const FacePlanes& planes, std::uint32_t group,
                        std::vector<std::uint32_t>& memory) {
    memory.clear();
    for (const std::uint32_t corner : rings.corners[group])
        if (rings.is_face(corner / 3)) memory.push_back(planes.plane_of[corner / 3]);
    std::sort(memory.begin(), memory.end());
    memory.erase(std::unique(memory.begin(), memory.end()), memory.end());
    PlanesAtPlace out;
    double all = 0, planar = 0, largest = -1;
    std::uint32_t of_largest = 0;
    for (const std::uint32_t plane : memory) {
        all += planes.area[plane];
        if (planes.faces[plane] >= 2) planar += planes.area[plane];
        if (planes.area[plane] > largest) largest = planes.area[plane], of_largest = plane;
    }
    if (!(all > 0)) return out;
    for (const std::uint32_t corner : rings.corners[group])
        if (rings.is_face(corner / 3) && planes.plane_of[corner / 3] == of_largest)
            out.normal += rings.face_normals[corner / 3];
    out.normal = normalize_or(out.normal, {});
    out.share = largest / all, out.planar_share = planar / all;
    out.rules = planes.faces[of_largest] >= 2 && memory.size() >= 2;
    return out;
}

}  // namespace rakelight::geometry
