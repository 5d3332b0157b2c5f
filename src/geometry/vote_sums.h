// SPDX-License-Identifier: Apache-2.0
// The sums: every face adds its votes to its three vertices, vertices of one group add theirs together.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/topology.h"
#include "geometry/vertex_groups.h"

namespace rakelight::geometry {

/// What the faces of one vertex (later: of its group) say together, in the world.
struct NormalRow {
    dvec3 normal;   ///< sum of weight * unit face normal
    double weight;  ///< sum of weights; 0: no face votes here
};
struct TangentRow {
    dvec3 tangent;  ///< sum of weight * unit face tangent
    double hand;    ///< sum of weight * handedness; a vertex has faces of one handedness only
};

/// A sum shorter than this share of its weights has cancelled.
constexpr double cancelled_share = 1e-6;
inline bool has_cancelled(const NormalRow& row) {
    return !(dot(row.normal, row.normal) > cancelled_share * cancelled_share * row.weight * row.weight);
}

struct VoteSums {
    BlockArray<NormalRow> normals;    ///< [output vertices]
    BlockArray<TangentRow> tangents;  ///< [output vertices], or unused: none are asked for
    std::vector<std::uint32_t> degenerate_faces, isolated_vertices;  ///< [meshes]
    std::vector<std::uint32_t> cancelled_groups;  ///< indices of VertexGroups whose normals cancelled
    bool makes_tangents = false;
    bool has_tangents() const { return makes_tangents; }
};

/// Where the appended vertices of each mesh begin, counted from the first appended one. [meshes + 1]
std::vector<std::uint32_t> appended_base(const Topology& topology, const AttributeInput& input);

/// Adds up the votes of all faces, per output vertex. Fixed chunks own vertex ranges; votes for another chunk's vertex are
/// handed over and added in the order of the chunks, so the bits do not depend on the threads.
/// @param normals, tangents  memory for the rows, of any contents
VoteSums sum_votes(const Topology& topology, const AttributeInput& input, const AttributeOptions& options,
                   Context& context, BlockArray<NormalRow>&& normals = {}, BlockArray<TangentRow>&& tangents = {});

/// Adds the rows of each group together and gives the sum to every member: normals as they are; tangents only among members of
/// one handedness whose own tangents lie within 45 degrees of one another in the normal's plane (connected pairs). Groups
/// whose normals cancel are listed and left as they are.
void sum_groups(VoteSums& sums, const VertexGroups& groups, const Topology& topology, const AttributeInput& input,
                const AttributeOptions& options, Context& context);

/// Output vertices, not locked, whose sum of normals (after sum_groups()) has cancelled though faces vote; ascending.
std::vector<std::uint32_t> cancelled_vertices(const VoteSums& sums, const Topology& topology,
                                              const AttributeInput& input, Context& context);

}  // namespace rakelight::geometry
