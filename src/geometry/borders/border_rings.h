// SPDX-License-Identifier: Apache-2.0
// The neighbors of leading border nodes on both sides of matched borders, to fit surfaces to.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/borders/border_links.h"

namespace rakelight::geometry {

/// Found in the matched pose; serves all poses.
struct BorderRings {
    std::vector<std::uint32_t> node;       ///< [rings] that lead, ascending
    std::vector<std::uint32_t> begin;      ///< [rings + 1] into `neighbors`
    std::vector<std::uint32_t> neighbors;  ///< global vertices, each at another place, nearest first

    std::span<const std::uint32_t> operator[](std::size_t ring) const {
        return std::span(neighbors).subspan(begin[ring], begin[ring + 1] - begin[ring]);
    }
};

/// Two rings of each side, along faces and links, not across hard edges. Rings of smaller faces than the node's own
/// reach farther: (area of its coarsest side / area)^(1/4) times as many. Of neighbors in about one direction and
/// distance only one is kept, so that both sides count alike.
/// @throws Error bad_file: over the memory budget
BorderRings border_rings(const PlacedMeshes& placed, const BorderNodes& nodes, std::span<const BorderLink> links,
                         Context& context);

}  // namespace rakelight::geometry
