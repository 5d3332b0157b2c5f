// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "math/linear.h"
#include "prepare/repair/repair.h"

namespace rakelight {
namespace {

// Beyond these, squared lengths and areas over- or underflow in float.
constexpr float huge_position = 1e18f;
constexpr float tiny_extent = 1e-12f;

template <class T>
Block<T> without_triangles(const Block<T>& block, const std::vector<std::uint8_t>& dropped, std::size_t per_triangle) {
    if (block.empty()) return block;
    std::vector<T> kept;
    for (std::size_t t = 0; t < dropped.size(); ++t)
        if (!dropped[t])
            kept.insert(kept.end(), block.begin() + t * per_triangle, block.begin() + (t + 1) * per_triangle);
    return Block<T>(std::move(kept));
}

void drop_broken_triangles(Mesh& mesh, std::vector<Finding>& findings) {
    std::vector<std::uint8_t> dropped(std::size_t(mesh.triangle_count()), 0);
    for (std::size_t c = 0; c < mesh.indices.size(); ++c)
        if (!is_finite(mesh.positions[mesh.indices[c]])) dropped[c / 3] = 1;
    if (std::find(dropped.begin(), dropped.end(), 1) != dropped.end()) {
        findings.push_back({Remark::dropped, "triangles with a position that is not finite were dropped"});
        mesh.indices = without_triangles(mesh.indices, dropped, 3);
        mesh.smoothing = without_triangles(mesh.smoothing, dropped, 1);
        mesh.smoothing_hint = without_triangles(mesh.smoothing_hint, dropped, 3);
        mesh.polygons = without_triangles(mesh.polygons, dropped, 1);
    }
    std::vector<vec3> positions(mesh.positions.begin(), mesh.positions.end());
    for (vec3& p : positions)
        if (!is_finite(p)) p = {0, 0, 0};
    mesh.positions = std::move(positions);
}

/// In double: exact for products of float differences, and without over- or underflow for 1e30 and 1e-30.
bool has_area(const Mesh& mesh, std::size_t t) {
    const auto corner = [&](std::size_t k) { return cast<double>(mesh.positions[mesh.indices[3 * t + k]]); };
    const dvec3 a = corner(0), n = cross(corner(1) - a, corner(2) - a);
    return n.x != 0 || n.y != 0 || n.z != 0;
}

bool any_triangle_has_area(const Mesh& mesh) {  // stops at the first one, usually at once
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
        if (has_area(mesh, t)) return true;
    return false;
}

}  // namespace

void repair_positions(Mesh& mesh, std::vector<Finding>& findings) {
    vec3 low{0, 0, 0}, high{0, 0, 0};
    bool first = true, all_finite = true;
    for (const vec3& p : mesh.positions) {
        if (!is_finite(p)) {
            all_finite = false;
            continue;
        }
        low = first ? p : min(low, p);
        high = first ? p : max(high, p);
        first = false;
    }
    if (!all_finite) drop_broken_triangles(mesh, findings);
    if (mesh.indices.empty()) return;
    if (!any_triangle_has_area(mesh))
        findings.push_back({Remark::warning, "all triangles have zero area: nothing of it can be seen"});
    const float largest = std::max({-low.x, -low.y, -low.z, high.x, high.y, high.z});
    const float extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    if (largest > huge_position)
        findings.push_back({Remark::warning, "positions are so large that their products leave the range of float"});
    if (extent > 0 && extent < tiny_extent)
        findings.push_back(
            {Remark::warning,
             "the mesh is so small (less than 1e-12 across) that products of its edges leave the range of float"});
}

}  // namespace rakelight
