// SPDX-License-Identifier: Apache-2.0
// Summation of votes: faces add their votes to their three vertices, and vertices of a group are summed.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/corners/topology.h"
#include "geometry/corners/vertex_groups.h"

namespace rakelight::geometry {

/// Sum over the faces of one vertex (later: of its group), in world space.
struct NormalRow {
    dvec3 normal;   ///< sum of weight * unit face normal
    double weight;  ///< sum of weights; 0: no votes
};
struct TangentRow {
    dvec3 tangent;  ///< sum of weight * unit face tangent
    double hand;    ///< sum of weight * handedness; a vertex has faces of one handedness only
};

/// A sum shorter than this share of its weights has cancelled.
constexpr double cancelled_share = 1e-6;
inline bool has_cancelled(const NormalRow& row) {
    const double square = dot(row.normal, row.normal);
    if (square > 1e-280 && square < 1e280)
        return !(square > cancelled_share * cancelled_share * row.weight * row.weight);
    const dvec3 share = row.normal * (1 / row.weight);  // squares of the weights of extreme slivers leave double
    return !(dot(share, share) > cancelled_share * cancelled_share);
}

struct VoteSums {
    BlockArray<NormalRow> normals;                                   ///< [output vertices]
    BlockArray<TangentRow> tangents;                                 ///< [output vertices], or unused without tangents
    std::vector<std::uint32_t> degenerate_faces, isolated_vertices;  ///< [meshes]
    std::vector<std::uint32_t> cancelled_groups;  ///< indices of VertexGroups whose normals cancelled
    bool makes_tangents = false;
    bool has_tangents() const { return makes_tangents; }
};

/// Where the appended vertices of each mesh begin, counted from the first appended one. [meshes + 1]
std::vector<std::uint32_t> appended_base(const Topology& topology, const AttributeInput& input);

/// Sums the votes of all faces per output vertex. Fixed chunks own vertex ranges. Votes for another chunk's vertex are
/// transferred and added in the order of the chunks, so the result is bit-identical for any number of threads.
/// @param normals, tangents reused memory for the rows
VoteSums sum_votes(const Topology& topology, const AttributeInput& input, const AttributeOptions& options,
                   Context& context, BlockArray<NormalRow>&& normals = {}, BlockArray<TangentRow>&& tangents = {});

/// Adds the normals of each group together and gives the sum to every member. Groups whose normals cancel are listed and left
/// as they are. Where members have authored normals, on the side of the sum, these are summed instead.
void sum_groups(VoteSums& sums, const VertexGroups& groups, const Topology& topology, const AttributeInput& input,
                const AttributeOptions& options, Context& context);

/// After sum_groups(): adds the tangents of each group together, among members of one handedness whose own tangents lie
/// within 45 degrees of one another in the normal's plane (connected pairs).
void average_tangents(VoteSums& sums, const VertexGroups& groups, const Topology& topology, const AttributeInput& input,
                      const AttributeOptions& options, Context& context);

/// Output vertices, not locked, whose sum of normals (after sum_groups()) has cancelled though faces vote; ascending.
std::vector<std::uint32_t> cancelled_vertices(const VoteSums& sums, const Topology& topology,
                                              const AttributeInput& input, Context& context);

}  // namespace rakelight::geometry
