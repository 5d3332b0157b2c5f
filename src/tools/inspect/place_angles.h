// SPDX-License-Identifier: Apache-2.0
// The angles between the normals of two parts at one place.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/math/vector.h>

namespace rakelight {

/// The normals of some corners of one part at a place: unit, in the world.
struct CornerNormals {
    dvec3 before, after;
};
struct PartAtPlace {
    std::uint32_t part = 0;
    std::span<const CornerNormals> corners;  ///< at least one
};

struct PairAngle {
    double before_deg = 0, after_deg = 0;
    bool joined = false;  ///< some corner of the one has the normal of some corner of the other, after
};

/// `after`: of the nearest two normals. `before`: of the nearest two in each group of corners that the smoothing joins,
/// the largest over the groups; of the nearest two of all where it joins none. O(a b).
PairAngle pair_angle(const PartAtPlace& a, const PartAtPlace& b);

/// At most `most` parts, in the order of the list: those whose first normals turn farthest from the mean, and the
/// nearest one.
std::vector<PartAtPlace> most_different(std::span<const PartAtPlace> parts, std::size_t most);

}  // namespace rakelight
