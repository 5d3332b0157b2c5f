// SPDX-License-Identifier: Apache-2.0
#include "radiosity/patches.h"

#include <algorithm>
#include <cmath>

#include "math/linear.h"

namespace rakelight::radiosity {
namespace {

/// Key of small elements of one patch: part, grid cell, main axis of the normal.
struct Key {
    std::uint32_t part = 0, axis = 0;
    std::int64_t x = 0, y = 0, z = 0;
    std::uint32_t alone = 0;  ///< unique number of a large triangle
    auto operator<=>(const Key&) const = default;
};

std::uint32_t main_axis(dvec3 n) {
    const dvec3 a{std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
    const std::uint32_t axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    return 2 * axis + (n[axis] < 0 ? 1 : 0);
}

Key key_of(const Element& e, std::uint32_t part, std::uint32_t number, double size) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, length(e.corner[k] - e.corner[(k + 1) % 3]));
    Key key{.part = part};
    if (longest > 0.4 * size) {
        key.alone = number + 1;
        return key;
    }
    const auto cell = [&](double v) { return std::int64_t(std::floor(v / size)); };
    key.axis = main_axis(e.face_normal);
    key.x = cell(e.center.x), key.y = cell(e.center.y), key.z = cell(e.center.z);
    return key;
}

Patch patch_of(const Elements& elements, std::span<const std::uint32_t> members) {
    Patch out;
    for (const std::uint32_t i : members) {
        const Element& e = elements.list[i];
        out.area += e.area;
        out.center += e.center * e.area;
        out.emission += e.emission * e.area;
    }
    out.center = out.center / out.area, out.emission = out.emission / out.area;
    for (const std::uint32_t i : members)
        for (const dvec3 corner : elements.list[i].corner) out.reach = std::max(out.reach, length(corner - out.center));
    return out;
}

/// The one of nine cells of a cube-map face that a normal hits.
std::size_t part_of_face(dvec3 n) {
    const std::uint32_t axis = main_axis(n) / 2;
    const auto third = [&](double v) { return std::size_t(std::clamp((v / std::fabs(n[axis]) + 1) * 1.5, 0.0, 2.0)); };
    return 3 * third(n[(axis + 1) % 3]) + third(n[(axis + 2) % 3]);
}

/// Members with normals in one cell count with their whole area, not its projection, which preserves the power of
/// curved surfaces.
void add_facets(const Elements& elements, std::span<const std::uint32_t> members, std::vector<dvec3>& facets) {
    struct Facet {
        dvec3 normal;
        double area = 0;
    } found[9];
    for (const std::uint32_t i : members) {
        const Element& e = elements.list[i];
        Facet& facet = found[part_of_face(e.face_normal)];
        facet.normal += e.face_normal * e.area, facet.area += e.area;
    }
    for (const Facet& facet : found)
        if (facet.area > 0) facets.push_back(normalize_or(facet.normal, dvec3{}) * facet.area);
}

}  // namespace

Patches make_patches(const Elements& elements, double size, PatchesOf of) {
    std::vector<std::pair<Key, std::uint32_t>> keys;
    for (std::uint32_t part = 0; part + 1 < elements.base.size(); ++part)
        for (std::uint32_t i = elements.base[part]; i < elements.base[part + 1]; ++i)
            if (elements.list[i].area > 0)
                keys.emplace_back(key_of(elements.list[i], of == PatchesOf::each_part ? part : 0, i, size), i);
    std::sort(keys.begin(), keys.end());
    Patches out;
    for (std::size_t first = 0; first < keys.size();) {
        std::size_t end = first;
        while (end < keys.size() && keys[end].first == keys[first].first) out.members.push_back(keys[end++].second);
        Patch patch = patch_of(elements, {out.members.data() + first, end - first});
        patch.begin = std::uint32_t(first), patch.end = std::uint32_t(end);
        patch.facets_begin = std::uint32_t(out.facets.size());
        add_facets(elements, out.of(patch), out.facets);
        patch.facets_end = std::uint32_t(out.facets.size());
        out.list.push_back(patch);
        first = end;
    }
    return out;
}

}  // namespace rakelight::radiosity
