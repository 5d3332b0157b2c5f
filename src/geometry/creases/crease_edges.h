// SPDX-License-Identifier: Apache-2.0
// Decides for each edge whether it is hard, from the planes on both sides: <rakelight/geometry/creases.h>.
#pragma once
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <rakelight/geometry/creases.h>

#include "geometry/corners/topology.h"

namespace rakelight::geometry {

/// The decisions for all faces, with global indices.
struct CreaseEdges {
    /// [T] bit k: the edge from corner k to the next is hard. Bit k + 3: the edge has no single partner; faces join only
    /// with their partner, or if they bend by less than `soft_below_deg`.
    std::vector<std::uint8_t> bits;
    /// Soft pairs at edges of more than two faces: a corner and its partner's, ascending, each pair in both orders.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> partners;
    CreaseReport report;

    /// Of the edge from a corner to the next one of its face.
    bool is_hard(std::uint32_t corner) const { return (bits[corner / 3] >> corner % 3 & 1) != 0; }
    bool is_crowded(std::uint32_t corner) const { return (bits[corner / 3] >> (corner % 3 + 3) & 1) != 0; }
    bool is_plainly_soft(std::uint32_t corner) const { return (bits[corner / 3] >> corner % 3 & 9) == 0; }
    /// Whether two corners are partners at a crowded edge.
    bool are_partners(std::uint32_t corner, std::uint32_t other) const;
    /// Whether two faces at one edge join. At an edge of more than two faces, partners do, and faces that hardly bend.
    /// @param corner, other  where the edge begins in each face
    /// @param cosine  between the normals of the faces
    bool are_soft(std::uint32_t corner, std::uint32_t other, double cosine) const;
};

/// Cosine of 6 degrees: faces that bend by less are soft wherever the thresholds move, without a look at the rule.
constexpr double cosine_of_always_soft = 0.9945218953682733;

/// @param places  [vertices] as Topology::places
CreaseEdges decide_creases(const AttributeInput& input, const std::vector<std::uint32_t>& places,
                           const FaceNormals& normals, Context& context);

}  // namespace rakelight::geometry
