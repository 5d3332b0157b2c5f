// SPDX-License-Identifier: Apache-2.0
// The faces at one corner group, each with the groups on its two sides: read once, for all that is asked of them.
#pragma once
#include <utility>
#include <vector>

#include "geometry/fits/group_rings.h"

namespace rakelight::geometry {

/// Faces without area are left out. Reused, so that it allocates nothing for most groups.
class Spokes {
public:
    void read(const GroupRings& rings, std::uint32_t group);

    std::uint32_t count() const { return count_; }
    std::uint32_t face(std::uint32_t i) const { return face_[i]; }

    /// Whether the faces close around the group, as the number and the sums of the groups on both sides say.
    bool goes_around() const { return sum_ == 0 && squares_ == 0; }

    /// Appends the groups that share an edge with this one, each once.
    void put_ring(std::vector<std::uint32_t>& to) const;

    using FacePair = std::pair<std::uint32_t, std::uint32_t>;
    /// Appends the pairs of flat faces that share an edge from the group to one of a higher number. A face that is turned
    /// around has no neighbor in its plane, and an edge of very many faces is in no plane.
    void put_flat_pairs(const GroupRings& rings, std::vector<FacePair>& to);

private:
    static constexpr std::uint32_t few = 8;

    void match();
    void put_any_pairs(const GroupRings& rings, std::vector<FacePair>& to);

    std::uint32_t group_ = 0, count_ = 0;
    std::vector<std::uint32_t> face_, next_,
        previous_;                          // [at least few] next_, previous_: counter-clockwise from outside
    std::uint64_t sum_ = 0, squares_ = 0;   // of next_ less that of previous_
    std::uint32_t matches_[few] = {};       // [few faces] bits of those that begin where it ends
    bool closes_ = false;                   // of few faces: each ends where just one other begins
    std::vector<FacePair> ahead_, behind_;  // of many faces: the group at the other end of an edge, and the face
};

}  // namespace rakelight::geometry
