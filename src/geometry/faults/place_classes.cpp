// SPDX-License-Identifier: Apache-2.0
#include "geometry/faults/place_classes.h"

#include <algorithm>

#include "geometry/weld/near_weld.h"
#include "geometry/weld/position_weld.h"

namespace rakelight::geometry {

namespace {

/// Peak memory: hashes, records and places; then cells of near places, two entries each.
void check_memory(const AttributeInput& input, double weld_distance, Context& context) {
    constexpr std::uint64_t exact = 24, near = 84;  // [bytes] a vertex
    const bool has_codes = std::any_of(input.meshes.begin(), input.meshes.end(),
                                       [](const AttributeMesh& m) { return m.position_step > 0; });
    const bool looks_near =
        weld_distance > 0 || (weld_distance < 0 && (has_codes || input.placements.distinct().size() > 1));
    context.memory().check(input.vertex_count() * (looks_near ? near : exact),
                           "finding where the vertices of all placements meet");
}

}  // namespace

PlacedMeshes place_vertices(std::span<const AttributeMesh> meshes, double weld_distance, Context& context) {
    PlacedMeshes placed;
    placed.input = check_input(meshes, context);
    check_memory(placed.input, weld_distance, context);
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
