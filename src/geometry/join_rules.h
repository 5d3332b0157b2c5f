// SPDX-License-Identifier: Apache-2.0
// Which of the faces around one place are joined into one smooth group.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/topology.h"
#include "geometry/union_find.h"

namespace rakelight::geometry {

/// What a stage of grouping is after.
enum class JoinRule : std::uint8_t {
    crease,  ///< creases, smoothing groups and hints (the user's choice)
    side,  ///< the two sides of coincident shells whose normals cancel: neighbors that run on, not those that turn back
    apart,  ///< nothing is joined: each face for itself
};

/// Cosine of 89.4 degrees: while each face of a group looks less far away from its first one, the sum of their weighted normals
/// is longer than a hundredth of the weights, so it cannot cancel.
constexpr double looks_away = 0.01;

/// Of the largest angle [rad] between faces that a crease angle joins; -2 for pi, which no cosine is below.
double crease_cosine(double crease_angle_rad);

/// One edge of a face, seen from one of its places.
struct Spoke {
    std::uint32_t place, index;  ///< other end of the edge (its position class); which corner of the fan
    bool outgoing;               ///< the face runs along the edge away from the fan's place
};

/// The faces at one place, as seen by the rules; index i is the i-th corner of the place.
struct Fan {
    std::vector<std::uint32_t> corner;  ///< global indices, ascending
    std::vector<std::uint32_t> mesh;    ///< of the corner
    std::vector<dvec3> normal;          ///< of its face; zero: no vote
    std::vector<std::uint64_t>
        authority;                     ///< faces of equal non-zero authority obey their groups, all others the angle
    std::vector<std::uint32_t> group;  ///< smoothing group or mask
    std::vector<GroupKind> kind;       ///< none with an authority: the hint rules
    std::vector<vec3> hint;
    std::vector<std::uint32_t> next, previous;  ///< scratch of JoinRules: places of a face's other corners
    std::vector<Spoke> spokes;                  ///< scratch of JoinRules

    std::size_t size() const { return corner.size(); }
    bool votes(std::size_t i) const { return normal[i] != dvec3{}; }
};

class JoinRules {
public:
    JoinRules(const AttributeInput& input, const Topology& topology, const AttributeOptions& options, JoinRule rule,
              const FaceNormals& normals);

    /// Whether all faces of a small place vote and are joined in one chain over common edges, and none looks away from the first
    /// one by 89 degrees or more; what is true of most places. False: the full rules must say. @param mesh  in, out: a guess
    bool is_calm(std::span<const std::uint32_t> corners, std::uint32_t& mesh) const;
    /// Reads what the rules need about the corners of one place.
    void gather(std::span<const std::uint32_t> corners, Fan& fan) const;
    /// Joins faces that vote; the others stay alone.
    void join(Fan& fan, UnionFind& sets) const;

private:
    void gather_groups(Fan& fan) const;
    double min_cos(const Fan& fan, std::uint32_t i, std::uint32_t j) const;
    bool joined(const Fan& fan, std::uint32_t i, std::uint32_t j) const;
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
    JoinRule rule_;
    bool groups_across_;
    bool joins_all_, joins_some_;  ///< crease angle pi, of all meshes, of some
    double min_cos_;               ///< of the crease angle
    /// [meshes] where crease angles differ, else empty: above is that of the smallest then.
    std::vector<double> own_cos_;
    bool has_groups_ = false, has_hints_ = false;
};

}  // namespace rakelight::geometry
