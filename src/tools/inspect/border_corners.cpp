// SPDX-License-Identifier: Apache-2.0
#include "tools/inspect/border_corners.h"

#include <algorithm>

#include "geometry/input/face_vote.h"

namespace rakelight {
namespace {

constexpr std::uint32_t nobody = 0xffffffffu, several = 0xfffffffeu;

/// Whether a face is a needle, 100000 times as long as high: it is invisible, and its direction is a rounding error.
bool is_needle(const geometry::PlacedMeshes& placed, std::uint32_t mesh, std::size_t first_corner) {
    const AttributeMesh& m = placed.input.meshes[mesh];
    const geometry::FaceCorners face = geometry::face_corners(m, &m.indices[first_corner]);
    const dmat3& linear = placed.input.placements[mesh].linear;
    const dvec3 a = linear * face.e1, b = linear * face.e2, c = b - a;
    const double longest = std::max({dot(a, a), dot(b, b), dot(c, c)});
    return !(length(cross(a, b)) > 1e-5 * longest);
}

template <class Body>
void for_each_corner(const geometry::PlacedMeshes& placed, const Body& body) {
    const geometry::AttributeInput& input = placed.input;
    geometry::FacePlaces face;
    for (std::uint32_t m = 0; m < input.meshes.size(); ++m)
        for (std::uint32_t t = input.triangle_base[m]; t < input.triangle_base[m + 1]; ++t) {
            const std::size_t first = 3 * std::size_t(t - input.triangle_base[m]);
            if (!geometry::face_places(placed, m, t, face) || is_needle(placed, m, first)) continue;
            for (std::uint32_t k = 0; k < 3; ++k) body(m, face.corner[k], first + k);
        }
}

}  // namespace

std::vector<BorderCorner> find_border_corners(const geometry::PlacedMeshes& placed, const SeamNormals& normals,
                                              Context& context) {
    std::vector<std::uint32_t> owner(placed.place.size(), nobody);
    for_each_corner(placed, [&](std::uint32_t m, std::uint32_t place, std::size_t) {
        if (owner[place] == nobody) owner[place] = m;
        if (owner[place] != m) owner[place] = several;
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
