// SPDX-License-Identifier: Apache-2.0
// Patches: pieces of surface that shoot light as one. A large triangle is a patch; small ones that lie together and look the
// same way are one patch together.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "radiosity/elements.h"

namespace rakelight::radiosity {

struct Patch {
    std::uint32_t begin = 0, end = 0;                ///< of Patches::members
    dvec3 center;                                    ///< mean by area
    std::uint32_t facets_begin = 0, facets_end = 0;  ///< of Patches::facets
    double area = 0;                                 ///< [m^2]
    double reach = 0;                                ///< [m] from the center to its farthest corner
    dvec3 emission;                                  ///< radiance, mean by area
};

struct Patches {
    std::vector<Patch> list;
    std::vector<std::uint32_t> members;  ///< elements, patch by patch
    /// [m^2] Patch by patch, for those far away: the area of members that look about the same way, along their mean normal.
    std::vector<dvec3> facets;
    std::span<const std::uint32_t> of(const Patch& p) const { return {members.data() + p.begin, p.end - p.begin}; }
    std::span<const dvec3> facets_of(const Patch& p) const {
        return {facets.data() + p.facets_begin, p.facets_end - p.facets_begin};
    }
};

/// Whether small triangles of several parts can be one patch.
enum class PatchesOf : std::uint8_t { each_part, all_parts };

/// @param elements  no edge is longer than `size` but where the scene's own triangles are to stay
/// @param size      [m] of what may become one patch
Patches make_patches(const Elements& elements, double size, PatchesOf of = PatchesOf::each_part);

}  // namespace rakelight::radiosity
