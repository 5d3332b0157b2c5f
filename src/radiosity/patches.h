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
    std::uint32_t begin = 0, end = 0;  ///< of Patches::members
    dvec3 center;                      ///< mean by area
    dvec3 area_normal;                 ///< [m^2] sum of the members' areas along their normals
    double area = 0;                   ///< [m^2]
    double reach = 0;                  ///< [m] from the center to its farthest corner
    dvec3 emission;                    ///< radiance, mean by area
};

struct Patches {
    std::vector<Patch> list;
    std::vector<std::uint32_t> members;  ///< elements, patch by patch
    std::span<const std::uint32_t> of(const Patch& p) const { return {members.data() + p.begin, p.end - p.begin}; }
};

/// Whether small triangles of several parts can be one patch.
enum class PatchesOf : std::uint8_t { each_part, all_parts };

/// @param elements  no edge is longer than `size` but where the scene's own triangles are to stay
/// @param size      [m] of what may become one patch
Patches make_patches(const Elements& elements, double size, PatchesOf of = PatchesOf::each_part);

}  // namespace rakelight::radiosity
