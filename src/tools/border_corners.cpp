// SPDX-License-Identifier: Apache-2.0
#include "tools/border_corners.h"

#include <algorithm>

namespace rakelight {
namespace {

constexpr std::uint32_t nobody = 0xffffffffu, several = 0xfffffffeu;

template <class Body>
void for_each_corner(const geometry::PlacedMeshes& placed, const Body& body) {
    const geometry::AttributeInput& input = placed.input;
    geometry::FacePlaces face;
    for (std::uint32_t m = 0; m < input.meshes.size(); ++m)
        for (std::uint32_t t = input.triangle_base[m]; t < input.triangle_base[m + 1]; ++t) {
            if (!geometry::face_places(placed, m, t, face)) continue;
            for (std::uint32_t k = 0; k < 3; ++k)
                body(m, face.corner[k], 3 * std::size_t(t - input.triangle_base[m]) + k);
        }
}

}  // namespace

std::vector<BorderCorner> find_border_corners(const geometry::PlacedMeshes& placed, const SeamNormals& normals,
                                              Context& context) {
    std::vector<std::uint32_t> owner(placed.place.size(), nobody);
    for_each_corner(placed, [&](std::uint32_t m, std::uint32_t place, std::size_t) {
        const std::uint32_t object = placed.input.meshes[m].object;
        if (owner[place] == nobody) owner[place] = object;
        if (owner[place] != object) owner[place] = several;
    });
    std::uint64_t count = 0;
    for_each_corner(placed, [&](std::uint32_t, std::uint32_t place, std::size_t) { count += owner[place] == several; });
    context.memory().check(count * sizeof(BorderCorner), "looking for shared borders");
    std::vector<BorderCorner> corners;
    corners.reserve(count);
    for_each_corner(placed, [&](std::uint32_t m, std::uint32_t place, std::size_t corner) {
        if (owner[place] != several) return;
        const std::span<const std::uint32_t> indices = placed.input.meshes[m].indices;
        corners.push_back(
            {place, m, normals.before[m].vertex(indices, corner), normals.after[m].vertex(indices, corner)});
    });
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

}  // namespace rakelight
