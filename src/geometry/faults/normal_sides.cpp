// SPDX-License-Identifier: Apache-2.0
#include "geometry/faults/normal_sides.h"

#include <algorithm>
#include <array>

#include "base/cancel_check.h"
#include "geometry/faults/edge_uses.h"
#include "geometry/input/face_vote.h"
#include "geometry/input/union_find.h"
#include "geometry/weld/position_weld.h"

namespace rakelight::geometry {
namespace {

constexpr std::uint64_t bytes_per_triangle = 64;  ///< of edges, sets and votes

/// Normals of a triangle's corners, normalized in world space.
std::array<dvec3, 3> corner_normals(const Placement& placement, const AttributeMesh& mesh, const std::uint32_t* index) {
    return {given_normal(placement, mesh.normals[index[0]]), given_normal(placement, mesh.normals[index[1]]),
            given_normal(placement, mesh.normals[index[2]])};
}

/// Sums of weight times cosine.
struct Votes {
    double uniform = 0, area = 0, angle = 0, angle_area = 0;

    void operator+=(const Votes& v) {
        uniform += v.uniform;
        area += v.area;
        angle += v.angle;
        angle_area += v.angle_area;
    }
    bool is_against() const { return uniform < 0 && area < 0 && angle < 0 && angle_area < 0; }
};

Votes votes_of(const AttributeInput& input, std::uint32_t mesh, std::uint32_t triangle) {
    const AttributeMesh& m = input.meshes[mesh];
    const Placement& placement = input.placements[mesh];
    const std::uint32_t* const index = m.indices.data() + 3 * std::size_t(triangle);
    const FaceCorners corners = face_corners(m, index);
    const Direction face = face_normal(placement, corners);
    if (!(face.length > 0)) return {};
    const std::array<dvec3, 3> normals = corner_normals(placement, m, index);
    const dvec3 cosines{dot(face.unit, normals[0]), dot(face.unit, normals[1]), dot(face.unit, normals[2])};
    const auto sum = [&](dvec3 weights) { return dot(weights, cosines); };
    return {sum(corner_weights<CornerWeight::uniform>(placement, corners, face.length)),
            sum(corner_weights<CornerWeight::area>(placement, corners, face.length)),
            sum(corner_weights<CornerWeight::angle>(placement, corners, face.length)),
            sum(corner_weights<CornerWeight::angle_area>(placement, corners, face.length))};
}

/// [triangles] whether the vertex normals oppose the triangle's winding.
std::vector<std::uint8_t> own_sides(const AttributeInput& input, Context& context) {
    std::vector<std::uint8_t> against(input.triangle_count());
    const std::vector<Chunk> chunks = make_chunks(input.triangle_base, triangles_per_chunk);
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        for_each_range(chunks[c], input.triangle_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const AttributeMesh& mesh = input.meshes[m];
            for (std::uint32_t t = first; t < last; ++t) {
                const std::uint32_t* const index = mesh.indices.data() + 3 * std::size_t(t);
                const FaceCorners corners = face_corners(mesh, index);
                const dvec3 normals = cast<double>(mesh.normals[index[0]]) + cast<double>(mesh.normals[index[1]]) +
                                      cast<double>(mesh.normals[index[2]]);
                against[input.triangle_base[m] + t] = dot(cross(corners.e1, corners.e2), normals) < 0;
            }
        });
    });
    return against;
}

/// The same for whole pieces.
void ask_pieces(const AttributeInput& input, std::vector<std::uint8_t>& against, Context& context) {
    const PlacedMeshes placed{input, weld_positions(input, {.normal = true}, context)};
    UnionFind pieces;
    pieces.reset(input.triangle_count());
    EdgeUses edges(placed, context);
    edges.for_each_edge([&](std::uint32_t place, std::span<const EdgeUse> uses) {
        if (uses.size() == 2 && edges.goes_up(place, uses[0]) != edges.goes_up(place, uses[1]))
            pieces.join(uses[0].corner / 3, uses[1].corner / 3);
    });
    CancelCheck check_cancel(context);
    std::vector<Votes> votes(input.triangle_count());
    for (std::uint32_t m = 0; m < input.meshes.size(); ++m)
        for (std::uint32_t t = input.triangle_base[m]; t < input.triangle_base[m + 1]; ++t) {
            check_cancel();
            votes[pieces.root(t)] += votes_of(input, m, t - input.triangle_base[m]);
        }
    for (std::uint32_t t = 0; t < input.triangle_count(); ++t) against[t] = votes[pieces.root(t)].is_against();
}

NormalSides sides_of(std::span<const std::uint8_t> against) {
    const auto count = std::size_t(std::count(against.begin(), against.end(), 1));
    NormalSides out;
    out.all_against = !against.empty() && count == against.size();
    if (count > 0 && count < against.size()) out.against.assign(against.begin(), against.end());
    return out;
}

}  // namespace

std::vector<NormalSides> find_normal_sides(std::span<const AttributeMesh> meshes, Context& context) {
    const AttributeInput input = number_input(meshes);
    std::vector<std::uint8_t> against = own_sides(input, context);
    const auto count = std::size_t(std::count(against.begin(), against.end(), 1));
    if (count > 0 && count < against.size()) {
        context.memory().check(bytes_per_triangle * against.size(), "the sides of triangles");
        ask_pieces(input, against, context);
    }
    std::vector<NormalSides> out;
    for (std::size_t m = 0; m < meshes.size(); ++m)
        out.push_back(sides_of(
            std::span(against).subspan(input.triangle_base[m], input.triangle_base[m + 1] - input.triangle_base[m])));
    return out;
}

}  // namespace rakelight::geometry
