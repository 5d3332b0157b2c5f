// SPDX-License-Identifier: Apache-2.0
#include "geometry/faults/mesh_islands.h"

#include <algorithm>
#include <numeric>

#include "geometry/attribute_plan.h"

namespace rakelight::geometry {
namespace {

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t m) {
    while (parent[m] != m) m = parent[m] = parent[parent[m]];
    return m;
}

}  // namespace

std::vector<std::uint32_t> mesh_islands(const AttributePlan& plan) {
    const AttributePlan::Impl& impl = plan.impl();
    const std::vector<std::uint32_t>& places = *impl.topology.places;
    std::vector<std::uint32_t> parent(impl.vertices.size()), mesh_of(places.size());
    std::iota(parent.begin(), parent.end(), 0u);
    std::size_t v = 0;
    for (std::uint32_t m = 0; m < parent.size(); ++m)
        for (const std::size_t end = v + impl.vertices[m]; v < end; ++v) {
            mesh_of[v] = m;
            // The leader of a place is its smallest vertex: of this mesh or one before.
            const std::uint32_t a = root_of(parent, mesh_of[places[v]]), b = root_of(parent, m);
            parent[std::max(a, b)] = std::min(a, b);
        }
    for (std::uint32_t m = 0; m < parent.size(); ++m)
        parent[m] = parent[parent[m]];  // those before are roots' children
    return parent;
}

}  // namespace rakelight::geometry
