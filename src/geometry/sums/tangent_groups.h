// SPDX-License-Identifier: Apache-2.0
// Averages tangents of vertices that share a normal, if their texture charts agree.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/input/union_find.h"
#include "geometry/sums/vote_sums.h"

namespace rakelight::geometry {

class TangentGroups {
public:
    /// @param normal unit, world; zero: no effect
    /// @param members  rows that share it; sets of one handedness, connected by pairs within 45 degrees, get their common sum.
    ///         A sum shorter than a thousandth of its weights (the pole of a sphere) leaves each its own.
    void average(dvec3 normal, std::span<const std::uint32_t> members, TangentRow* rows);

private:
    void join(std::span<const std::uint32_t> members, const TangentRow* rows, bool right);
    UnionFind sets_;
    std::vector<dvec3> direction_, sum_;
    std::vector<double> hand_;
    std::vector<std::uint32_t> list_;
};

}  // namespace rakelight::geometry
