// SPDX-License-Identifier: Apache-2.0
// Converts corner tangents to vertex tangents; vertices with different corners are split.
#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <tuple>

#include "geometry/input/perpendicular.h"
#include "geometry/tangents/mikktspace.h"

namespace rakelight::geometry {
namespace {

constexpr std::uint32_t no_index = 0xffffffffu;

// The result arrays, with source attributes copied for each vertex.
struct Expanded {
    std::vector<vec3> positions;
    std::vector<vec2> texcoords;
    std::vector<std::uint32_t> source;  // [V'] in the input
    std::vector<std::uint32_t> indices;
};

Expanded expand(const AttributeMesh& mesh, const MeshAttributes& result) {
    Expanded e;
    e.source.resize(mesh.positions.size());
    std::iota(e.source.begin(), e.source.end(), 0u);
    e.source.insert(e.source.end(), result.source_vertex.begin(), result.source_vertex.end());
    for (const std::uint32_t v : e.source) {
        e.positions.push_back(mesh.positions[v]);
        e.texcoords.push_back(mesh.texcoords[v]);
    }
    e.indices = result.indices;
    if (e.indices.empty()) e.indices.assign(mesh.indices.begin(), mesh.indices.end());
    return e;
}

auto bits(vec4 t) { return std::bit_cast<std::array<std::uint32_t, 4>>(t); }

struct Variant {
    std::uint32_t source, vertex, corner;  // its source; the first corner that uses it
};

// Gives each vertex the tangent of its first corner, and lists the other tangents that its corners have.
class Split {
public:
    Split(std::vector<std::uint32_t>& indices, const std::vector<vec4>& corners, std::size_t vertices)
        : indices_(indices), corners_(corners), first_(vertices, no_index) {}

    std::vector<Variant> run(const std::vector<std::uint32_t>& source) {
        std::vector<bool> mixed(first_.size(), false);
        for (std::uint32_t i = 0; i < indices_.size(); ++i) {
            std::uint32_t& first = first_[indices_[i]];
            if (first == no_index)
                first = i;
            else if (bits(corners_[i]) != bits(corners_[first]))
                mixed[indices_[i]] = true;
        }
        std::vector<std::uint32_t> order;
        for (std::uint32_t i = 0; i < indices_.size(); ++i)
            if (mixed[indices_[i]]) order.push_back(i);
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::tuple(indices_[a], bits(corners_[a]), a) < std::tuple(indices_[b], bits(corners_[b]), b);
        });
        std::vector<Variant> variants;
        for (std::size_t i = 0; i < order.size(); ++i) {
            const std::uint32_t c = order[i], v = indices_[c];
            if (bits(corners_[c]) == bits(corners_[first_[v]])) continue;
            const bool starts =
                i == 0 || indices_[order[i - 1]] != v || bits(corners_[order[i - 1]]) != bits(corners_[c]);
            if (starts) variants.push_back({source[v], v, c});
            variant_of_.emplace_back(c, std::uint32_t(variants.size() - 1));
        }
        return variants;
    }

    std::uint32_t first_corner(std::uint32_t vertex) const { return first_[vertex]; }
    const std::vector<std::pair<std::uint32_t, std::uint32_t>>& variant_of() const { return variant_of_; }

private:
    std::vector<std::uint32_t>& indices_;
    const std::vector<vec4>& corners_;
    std::vector<std::uint32_t> first_;                                 // [V'] first corner, or none
    std::vector<std::pair<std::uint32_t, std::uint32_t>> variant_of_;  // corner, variant
};

vec4 whole(vec4 t, vec3 normal) {
    if (t.x != 0 || t.y != 0 || t.z != 0) return t;
    const vec3 p = cast<float>(perpendicular(cast<double>(normal)));
    return {p.x, p.y, p.z, t.w};
}

}  // namespace

void give_mikktspace(const AttributeMesh& mesh, MeshAttributes& result) {
    Expanded e = expand(mesh, result);
    const std::vector<vec4> corners = mikktspace_corners({e.positions, result.normals, e.texcoords, e.indices});
    const std::uint32_t fixed = std::uint32_t(mesh.positions.size()), old_count = std::uint32_t(e.source.size());
    Split split(e.indices, corners, old_count);
    const std::vector<Variant> variants = split.run(e.source);

    // Appended vertices, old and new, in the order of their sources; then of the first corners.
    std::vector<Variant> appended;
    for (std::uint32_t v = fixed; v < old_count; ++v) appended.push_back({e.source[v], v, split.first_corner(v)});
    appended.insert(appended.end(), variants.begin(), variants.end());
    std::vector<std::uint32_t> order(appended.size()), number(appended.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tuple(appended[a].source, appended[a].corner, a) <
               std::tuple(appended[b].source, appended[b].corner, b);
    });
    for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = fixed + i;

    for (std::uint32_t& v : e.indices)
        if (v >= fixed) v = number[v - fixed];
    for (const auto& [corner, variant] : split.variant_of()) e.indices[corner] = number[old_count - fixed + variant];
    MeshAttributes out = result;
    out.normals.resize(fixed);
    out.tangents.clear();
    out.source_vertex.clear();
    for (std::uint32_t v = 0; v < fixed; ++v) {
        const std::uint32_t c = split.first_corner(v);
        out.tangents.push_back(whole(c == no_index ? vec4{0, 0, 0, 1} : corners[c], result.normals[v]));
    }
    for (const std::uint32_t i : order) {
        const Variant& a = appended[i];
        out.source_vertex.push_back(a.source);
        out.normals.push_back(result.normals[a.vertex]);
        out.tangents.push_back(whole(a.corner == no_index ? vec4{0, 0, 0, 1} : corners[a.corner], out.normals.back()));
    }
    if (!appended.empty()) out.indices = std::move(e.indices);
    result = std::move(out);
}

}  // namespace rakelight::geometry
