// SPDX-License-Identifier: Apache-2.0
#include "radiosity/patches.h"

#include <algorithm>
#include <cmath>

#include "math/linear.h"

namespace rakelight::radiosity {
namespace {

/// Patches of more members are halved.
constexpr std::size_t max_members = 8;

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

Patch patch_of(const Elements& elements, std::uint32_t begin, std::uint32_t end, Patches& patches) {
    Patch out{.begin = begin, .end = end};
    const std::span<const std::uint32_t> members = patches.of(out);
    for (const std::uint32_t i : members) {
        const Element& e = elements.list[i];
        out.area += e.area;
        out.center += e.center * e.area;
        out.emission += e.emission * e.area;
    }
    out.center = out.center / out.area, out.emission = out.emission / out.area;
    for (const std::uint32_t i : members)
        for (const dvec3 corner : elements.list[i].corner) out.reach = std::max(out.reach, length(corner - out.center));
    out.facets_begin = std::uint32_t(patches.facets.size());
    add_facets(elements, members, patches.facets);
    out.facets_end = std::uint32_t(patches.facets.size());
    return out;
}

/// Orders the members along the longest axis of their centers.
/// @return the first of the second half
std::uint32_t halve_members(const Elements& elements, const Patch& patch, Patches& patches) {
    const std::span<std::uint32_t> members(patches.members.data() + patch.begin, patch.end - patch.begin);
    dvec3 low{INFINITY, INFINITY, INFINITY}, high = -low;
    for (const std::uint32_t i : members) {
        low = min(low, elements.list[i].center), high = max(high, elements.list[i].center);
    }
    const dvec3 size = high - low;
    const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::ranges::sort(members, [&](std::uint32_t a, std::uint32_t b) {
        const double at = elements.list[a].center[axis], bt = elements.list[b].center[axis];
        return at != bt ? at < bt : a < b;
    });
    return patch.begin + std::uint32_t(members.size() / 2);
}

void add_halves(const Elements& elements, Patch& patch, Patches& patches) {
    if (patch.end - patch.begin <= max_members) return;
    const std::uint32_t middle = halve_members(elements, patch, patches);
    patch.halves = std::uint32_t(patches.parts.size());
    patches.parts.resize(patches.parts.size() + 2);
    for (std::uint32_t half = 0; half < 2; ++half) {
        Patch part = patch_of(elements, half == 0 ? patch.begin : middle, half == 0 ? middle : patch.end, patches);
        add_halves(elements, part, patches);
        patches.parts[patch.halves + half] = part;
    }
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
        Patch patch = patch_of(elements, std::uint32_t(first), std::uint32_t(end), out);
        add_halves(elements, patch, out);
        out.list.push_back(patch);
        first = end;
    }
    return out;
}

}  // namespace rakelight::radiosity
