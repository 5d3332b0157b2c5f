// SPDX-License-Identifier: Apache-2.0
// CornerWeight::fit and CornerWeight::automatic at matched borders: the normals of leading nodes by one height function
// over both sides.
#pragma once
#include "geometry/borders/border_rings.h"

namespace rakelight::geometry {

/// The sums of votes at border nodes.
struct BorderVotes {
    std::span<const std::uint8_t> changes;  ///< [nodes] leaders whose followers do not agree yet; only these are fitted
    std::span<const dvec3> by_angle;        ///< [nodes] with the weights of CornerWeight::angle; any length
    std::span<dvec3> normals;               ///< [nodes] with those of CornerWeight::max, unit; replaced
};

/// Normals of leaders: of fits as far as these are trusted. Where they are not, small triangles are not to be trusted
/// either, and the votes count by angles. Where they are but a gap lies between the sides, the votes by Max: the other
/// side's points are not where the surface would go on.
/// @throws Error bad_file: over the memory budget
void fit_borders(const AttributeInput& input, const BorderNodes& nodes, std::span<const BorderLink> links,
                 const BorderRings& rings, const BorderVotes& votes, Context& context);

}  // namespace rakelight::geometry
