// SPDX-License-Identifier: Apache-2.0
// The corners at one place that several meshes share: which of them have one authored normal, and which of these fans
// are joined across meshes. The rules are in <rakelight/geometry/seams.h>.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/creases/crease_edges.h"
#include "geometry/groups/join_rules.h"
#include "geometry/input/union_find.h"
#include "math/linear.h"

namespace rakelight::geometry {

/// Another corner of the same face.
struct OtherCorner {
    std::uint32_t place = 0;
    bool may_turn = false;  ///< several meshes have faces there
    dvec3 direction{};      ///< unit, world space, to there
    dvec3 authored{};       ///< unit, world space; zero: unusable
};

/// One corner of a face at the place.
struct SeamCorner {
    std::uint32_t mesh = 0, vertex = 0;  ///< global vertex index
    std::uint32_t corner = 0;            ///< global index
    dvec3 authored;                      ///< its normal, unit, world space; zero: unusable
    dvec3 face;                          ///< the face normal, unit, world space; zero: none
    dvec3 square;                        ///< square_normal() of the face
    double angle = 0;                    ///< of the face at this corner [rad]
    OtherCorner next, previous;
};

/// The corners of one mesh that have one authored normal.
struct AuthoredFan {
    std::uint32_t mesh = 0;
    dvec3 normal;      ///< unit
    double angle = 0;  ///< sum of its corners'
};

/// What may join across an edge between meshes.
struct SeamRules {
    std::vector<double> cosines;           ///< [meshes] the crease_cosine() of each; -2: the mesh follows the rule
    std::vector<std::uint8_t> follows;     ///< [meshes] whether `creases` decides at the mesh's edges
    std::optional<CreaseEdges> creases{};  ///< if SeamFans::needs_creases()
};

/// The fans at one place. The object is reused for all places to keep its memory.
class SeamFans {
public:
    explicit SeamFans(const SeamRules& rules) : rules_(rules) {}

    /// Finds fans and joins them.
    /// @param place    the place's number: pairs are counted at the smaller one of the edge's two
    /// @param corners  at least one, by ascending mesh
    void find(std::uint32_t place, std::span<const SeamCorner> corners);

    /// [corners] fan of each corner; `no_fan` for unusable normals.
    std::span<const std::uint32_t> fan_of() const { return fan_of_; }
    std::span<const AuthoredFan> fans() const { return fans_; }
    /// The representative of the joined fans; the fan itself if it is not joined.
    std::uint32_t joined(std::uint32_t fan) { return sets_.root(fan); }
    /// For a representative: whether its fans contain a seam to close.
    bool is_open(std::uint32_t fan) const { return is_open_[fan] != 0; }
    /// Whether a decision of the rule was missing, for any call of find(). Then the results are not valid.
    bool needs_creases() const { return needs_creases_; }
    /// Pairs of faces that stay hard at edges from here to larger places: flat ones, and other creases.
    std::uint64_t flat_pairs() const { return flat_pairs_; }
    std::uint64_t crease_pairs() const { return crease_pairs_; }

    static constexpr std::uint32_t no_fan = 0xffffffffu;

private:
    struct FanSum {
        dvec3 normals{};        ///< weighted by the corners' angles
        bool is_mixed = false;  ///< they differ, within `authored_equality`
    };
    /// Two faces of two meshes at one edge.
    struct Contact {
        std::uint32_t f, g;   ///< fans, f < g
        std::uint32_t p, q;   ///< corners: of the face of f, and of that of g
        std::uint32_t place;  ///< the edge's other end
        dvec3 along;          ///< unit, of the edge
        double cosine;        ///< between the faces
        bool is_open;         ///< the normals of the two corners differ
    };
    /// How far the normals of a fan differ from its faces [rad].
    struct Lean {
        double across = 0;      ///< perpendicular to an edge, with the normals elsewhere that count
        double whole = 0;       ///< of the normals here, in any direction
        bool is_shown = false;  ///< any normal elsewhere counts
    };
    struct Joint {
        std::uint32_t a, b;  ///< fans, a < b
        double apart;        ///< square of the distance between their normals; exactly 0 for equal ones
        double bend;         ///< cosine between the faces
        bool is_open;        ///< the normals of the two corners differ
    };
    void find_fans(std::span<const SeamCorner> corners);
    void sort_corners(std::span<const SeamCorner> corners);
    void find_fans_of_mesh(std::span<const SeamCorner> corners, std::uint32_t first);
    void find_joints(std::uint32_t place, std::span<const SeamCorner> corners);
    void sort_by_fan();
    void find_contacts(std::uint32_t place, std::span<const SeamCorner> corners);
    void look_at_edge(std::span<const SeamCorner> corners, std::span<const Spoke> edge);
    void look_at_pair(std::span<const SeamCorner> corners, const Spoke& a, const Spoke& b);
    bool are_soft(const SeamCorner& p, bool p_outgoing, const SeamCorner& q, bool q_outgoing, double cosine);
    void look_at_fans(std::uint32_t place, std::span<const SeamCorner> corners, std::span<const Contact> contacts);
    Lean lean(std::span<const SeamCorner> corners, std::uint32_t fan, std::span<const Contact> contacts,
              std::uint32_t Contact::*own) const;
    static bool shows_crease(const Lean& lean, double bend);
    void join_all();
    void join_nearest_first();
    bool comes_before(const Joint& a, const Joint& b) const;

    const SeamRules& rules_;
    std::vector<std::uint32_t> fan_of_;                       ///< [corners]
    std::vector<std::uint8_t> is_flat_;                       ///< [corners] whether their faces are authored flat
    std::vector<std::uint32_t> order_, leads_, fan_of_lead_;  ///< of one mesh: scratch
    std::vector<FanSum> sums_;
    std::vector<AuthoredFan> fans_;
    std::vector<std::uint32_t> by_fan_, first_of_;  ///< corners by their fans; [fans + 1] where those of a fan begin
    std::vector<std::uint8_t> is_open_;             ///< [fans]
    std::vector<Spoke> spokes_;
    std::vector<Contact> contacts_;
    std::vector<Joint> joints_;
    UnionFind sets_, alike_;
    bool needs_creases_ = false;
    std::uint64_t flat_pairs_ = 0, crease_pairs_ = 0;
};

}  // namespace rakelight::geometry
