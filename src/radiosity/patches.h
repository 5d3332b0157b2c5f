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
    std::uint32_t near_begin = 0, near_end = 0;      ///< of Patches::near
    double area = 0;                                 ///< [m^2]
    double reach = 0;                                ///< [m] bounding radius about the center
    dvec3 emission;                                  ///< radiance, mean by area
};

/// A member that stands for a share of its patch's area.
struct NearMember {
    std::uint32_t element;
    double factor;  ///< this share / the member's own area
};

struct Patches {
    std::vector<Patch> list;
    std::vector<std::uint32_t> members;  ///< elements, grouped by patch
    /// [m^2] grouped by patch, for distant receivers: areas of members of similar orientation, projected on their mean
    /// normal.
    std::vector<dvec3> facets;
    /// Grouped by patch, for near receivers: the members; a few of them where they are scattered, such as dust or leaves,
    /// because a few triangles in wide space give little light each.
    std::vector<NearMember> near;
    std::size_t scattered = 0;  ///< patches of which `near` has only a few members
    std::span<const std::uint32_t> of(const Patch& p) const { return {members.data() + p.begin, p.end - p.begin}; }
    std::span<const dvec3> facets_of(const Patch& p) const {
        return {facets.data() + p.facets_begin, p.facets_end - p.facets_begin};
    }
    std::span<const NearMember> near_of(const Patch& p) const {
        return {near.data() + p.near_begin, p.near_end - p.near_begin};
    }
};

/// Whether patches may combine small triangles of several parts.
enum class PatchesOf : std::uint8_t { each_part, all_parts };

/// @param elements no edge is longer than `size`, except in unsplit triangles of the scene
/// @param size [m] maximum size of a combined patch
Patches make_patches(const Elements& elements, double size, PatchesOf of = PatchesOf::each_part);

}  // namespace rakelight::radiosity
