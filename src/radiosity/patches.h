// SPDX-License-Identifier: Apache-2.0
// Patches: surface pieces that shoot light as a unit. A large triangle is a patch; small adjacent triangles of similar
// orientation are combined.
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
    std::uint32_t halves = 0;                        ///< of Patches::parts, two of them; 0: none
    double area = 0;                                 ///< [m^2]
    double reach = 0;                                ///< [m] bounding radius about the center
    dvec3 emission;                                  ///< radiance, mean by area
};

struct Patches {
    std::vector<Patch> list;
    std::vector<std::uint32_t> members;  ///< elements, grouped by patch
    /// [m^2] grouped by patch, for distant receivers: areas of members of similar orientation, projected on their mean
    /// normal.
    std::vector<dvec3> facets;
    /// Halves of patches of many members, and of such halves, for near receivers: what is far from them is not summed
    /// over its members. The first is of no patch.
    std::vector<Patch> parts = std::vector<Patch>(1);
    std::span<const Patch> halves_of(const Patch& p) const {
        return p.halves == 0 ? std::span<const Patch>() : std::span(parts).subspan(p.halves, 2);
    }
    std::span<const std::uint32_t> of(const Patch& p) const { return {members.data() + p.begin, p.end - p.begin}; }
    std::span<const dvec3> facets_of(const Patch& p) const {
        return {facets.data() + p.facets_begin, p.facets_end - p.facets_begin};
    }
};

/// Whether patches may combine small triangles of several parts.
enum class PatchesOf : std::uint8_t { each_part, all_parts };

/// @param elements no edge is longer than `size`, except in unsplit triangles of the scene
/// @param size [m] maximum size of a combined patch
Patches make_patches(const Elements& elements, double size, PatchesOf of = PatchesOf::each_part);

}  // namespace rakelight::radiosity
