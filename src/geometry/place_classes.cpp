// SPDX-License-Identifier: Apache-2.0
#include "geometry/place_classes.h"

#include "geometry/near_weld.h"
#include "geometry/position_weld.h"

namespace rakelight::geometry {

PlacedMeshes place_vertices(std::span<const AttributeMesh> meshes, double weld_distance, Context& context) {
    PlacedMeshes placed;
    placed.input = check_input(meshes, context);
    placed.place = weld_positions(placed.input, {}, context);
    weld_near(placed.place, placed.input, {}, weld_distance, context);
    return placed;
}

bool face_places(const PlacedMeshes& placed, std::uint32_t mesh, std::uint32_t triangle, FacePlaces& out) {
    const AttributeMesh& m = placed.input.meshes[mesh];
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = m.indices[3 * std::size_t(triangle - placed.input.triangle_base[mesh]) + k];
        if (!is_finite(m.positions[v])) return false;
        out.corner[k] = placed.place[placed.input.vertex_base[mesh] + v];
    }
    const auto [a, b, c] = out.corner;
    return a != b && b != c && c != a;
}

}  // namespace rakelight::geometry
