// SPDX-License-Identifier: Apache-2.0
// Sums votes along the links of matched borders, and computes normals and tangents from them.
#pragma once
#include <span>
#include <vector>

#include <rakelight/geometry/matching_borders.h>

#include "geometry/borders/border_rings.h"

namespace rakelight::geometry {

class BorderSums {
public:
    /// @param links  by depth
    /// @param rings  for fits of leaders; empty: these get their sums
    /// All outlive it.
    BorderSums(const AttributeInput& input, std::span<const std::span<const vec4>> tangents, const BorderNodes& nodes,
               std::span<const BorderLink> links, const BorderRings& rings, CornerWeight weight);
    std::vector<MeshSeams> run(MatchReport& report, Context& context);

private:
    /// Tangent of a vertex in world space. hand 0: none.
    struct Tangent {
        dvec3 unit, sum;
        double hand = 0;
        std::uint32_t lead = 0;  ///< the first member of its node with the same tangent
        bool received = false, is_set = false;
    };

    void weigh_members(Context& context);
    void read_tangents();
    void share_out();
    void share_tangents(const BorderLink& link);
    bool agrees(const Tangent& own, const BorderLink& link) const;
    dvec3 between(const BorderLink& link) const;
    dvec3 tangent_between(const BorderLink& link) const;
    void lead();
    void fit_leaders(Context& context);
    void lead_tangents();
    void follow();
    void set_tangent(std::uint32_t member, dvec3 sum);
    void write(std::uint32_t node, std::vector<MeshSeams>& out, MatchReport& report, double& sum) const;
    vec4 tangent_in_object(std::uint32_t member, std::uint32_t mesh, dvec3 normal) const;
    std::uint32_t mesh_of(std::uint32_t member) const { return input_.mesh_of_vertex(nodes_.members[member]); }

    const AttributeInput& input_;
    std::span<const std::span<const vec4>> given_tangents_;
    const BorderNodes& nodes_;
    std::span<const BorderLink> links_;
    const BorderRings& rings_;
    CornerWeight weight_;
    std::vector<std::uint8_t> is_open_;  ///< [nodes] a follower does not agree yet
    std::vector<std::uint8_t> role_;     ///< [nodes]
    std::vector<double> member_weight_;  ///< [members]
    std::vector<dvec3> normals_, sums_;  ///< [nodes] current and new normals; sums of votes
    std::vector<double> weights_;        ///< [nodes] of the votes
    std::vector<Tangent> tangents_;      ///< [members], or empty
};

}  // namespace rakelight::geometry
