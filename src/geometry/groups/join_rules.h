// SPDX-License-Identifier: Apache-2.0
// Joins the faces around a place to smooth groups.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/corners/topology.h"
#include "geometry/creases/crease_edges.h"
#include "geometry/input/union_find.h"

namespace rakelight::geometry {

/// The criterion of a grouping stage.
enum class JoinRule : std::uint8_t {
    crease,  ///< creases, smoothing groups and hints (options)
    side,  ///< the two sides of coincident shells whose normals cancel: joins neighbors that continue, not those that fold back
    apart,  ///< no joins: each face separately
};

/// Cosine of 89.4 degrees: if all faces of a group are within this angle of the first one, the sum of weighted normals
/// is longer than a hundredth of the weights, so it cannot cancel.
constexpr double looks_away = 0.01;

/// Cosine of the largest angle [rad] joined by a crease angle; -2 for pi, which is below every cosine.
double crease_cosine(double crease_angle_rad);

/// One edge of a face, seen from one of its places.
struct Spoke {
    std::uint32_t place, index;  ///< other end of the edge (its position class); index of the corner in the fan
    bool outgoing;               ///< the face uses the edge away from the fan's place
};

/// The faces at one place; index i is the i-th corner of the place.
struct Fan {
    std::vector<std::uint32_t> corner;  ///< global indices, ascending
    std::vector<std::uint32_t> mesh;    ///< of the corner
    std::vector<dvec3> normal;          ///< of its face; zero: no vote
    std::vector<std::uint64_t>
        authority;  ///< faces of equal nonzero authority join by their groups, all others by the angle
    std::vector<std::uint32_t> group;  ///< smoothing group or mask
    std::vector<GroupKind> kind;       ///< none with an authority: the hint decides
    std::vector<vec3> hint;
    std::vector<std::uint32_t> next, previous;  ///< scratch of JoinRules: places of a face's other corners
    std::vector<Spoke> spokes;                  ///< scratch of JoinRules

    std::size_t size() const { return corner.size(); }
    bool votes(std::size_t i) const { return normal[i] != dvec3{}; }
};

class JoinRules {
public:
    /// @param creases  for meshes that follow the rule; null: there are none
    JoinRules(const AttributeInput& input, const Topology& topology, const AttributeOptions& options, JoinRule rule,
              const FaceNormals& normals, const CreaseEdges* creases = nullptr);

    /// Fast test for the common case: all faces of a small place vote, are joined in one chain over common edges, and
    /// are within 89 degrees of the first one. False: the full rules are needed.
    /// @param mesh in, out: a guess
    bool is_calm(std::span<const std::uint32_t> corners, std::uint32_t& mesh) const;
    /// Loads the data of the corners of one place.
    void gather(std::span<const std::uint32_t> corners, Fan& fan) const;
    /// Joins faces with a vote; the others stay single.
    void join(Fan& fan, UnionFind& sets) const;

private:
    void gather_groups(Fan& fan) const;
    double min_cos(const Fan& fan, std::uint32_t i, std::uint32_t j) const;
    bool joined(const Fan& fan, std::uint32_t i, std::uint32_t j) const;
    bool follows_rule(std::uint32_t mesh) const { return creases_ && input_.meshes[mesh].crease_angle_rad < 0; }
    bool obeys_rule(const Fan& fan, const Spoke& a, const Spoke& b) const;
    bool is_plainly_soft(std::uint32_t corner, std::uint32_t other, bool forwards) const;
    void join_pairs_by_rule(const Fan& fan, UnionFind& sets) const;
    bool joined(const Fan& fan, const Spoke& a, const Spoke& b) const;
    void gather_places(Fan& fan) const;
    void join_pairs(const Fan& fan, UnionFind& sets) const;
    void join_edges(Fan& fan, UnionFind& sets) const;
    void join_edge(const Fan& fan, std::span<const Spoke> spokes, UnionFind& sets) const;
    void join_many_by_angle(const Fan& fan, std::span<const Spoke> spokes, UnionFind& sets) const;
    void join_around(const Fan& fan, std::span<const Spoke> spokes, UnionFind& sets) const;
    void join_many_by_group(const Fan& fan, std::span<const Spoke> spokes, UnionFind& sets) const;
    void join_everything(const Fan& fan, UnionFind& sets) const;
    void join_hints(const Fan& fan, UnionFind& sets) const;
    std::uint64_t authority_of(std::uint32_t mesh) const;
    struct CalmFan;
    bool gather_calm(std::span<const std::uint32_t> corners, std::uint32_t& mesh, CalmFan& fan) const;

    const AttributeInput& input_;
    const std::uint32_t* places_;  ///< [input vertices]
    const dvec3* normals_;         ///< [triangles]
    const CreaseEdges* creases_;   ///< null: angles alone
    JoinRule rule_;
    bool groups_across_;
    bool joins_all_, joins_some_;  ///< crease angle pi, of all meshes, of some
    double min_cos_;               ///< of the crease angle
    /// [meshes] where crease angles differ, else empty: above is that of the smallest then.
    std::vector<double> own_cos_;
    bool has_groups_ = false, has_hints_ = false, has_own_angles_ = false;
};

}  // namespace rakelight::geometry
