// SPDX-License-Identifier: Apache-2.0
#include "radiosity/cut.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/linear.h"

namespace rakelight::radiosity {
namespace {

constexpr int max_rounds = 40;

/// Bisects edges longer than `edge`.
/// @return false: there would be more elements than `most`
bool cut_longer(const std::vector<Part>& parts, std::vector<geometry::FineMesh>& meshes, double edge,
                std::uint64_t most, Context& context) {
    const double squared = edge * edge;
    const auto is_long = [=](dvec3 a, dvec3 b) { return dot(a - b, a - b) > squared; };
    for (int round = 0; round < max_rounds; ++round) {
        const std::uint64_t before = count_sides(parts, meshes);
        if (!geometry::halve_edges(meshes, is_long, most, context)) return false;
        const std::uint64_t after = count_sides(parts, meshes);
        if (after > most) return false;
        if (after == before) return true;
    }
    return true;
}

double area_of(const Elements& elements) {
    double area = 0;
    for (const Element& e : elements.list) area += e.area;
    return area;
}

}  // namespace

PatchLevel cut_to_patches(const CutScene& cut, const std::vector<geometry::FineMesh>& whole, std::size_t max_patches,
                          std::uint64_t max_elements, Context& context) {
    PatchLevel out{.meshes = whole, .elements = cut.elements_of(whole, context)};
    const double even = std::sqrt(3 * area_of(out.elements) / double(max_patches));
    for (const auto& [of, rounds] :
         {std::pair{PatchesOf::each_part, 12}, std::pair{PatchesOf::all_parts, max_rounds}}) {
        double edge = even;
        for (int round = 0; round < rounds && edge > 0; ++round, edge *= 1.2) {
            std::vector<geometry::FineMesh> meshes = whole;
            if (!cut_longer(cut.parts, meshes, edge, max_elements, context)) continue;
            Elements elements = cut.elements_of(meshes, context);
            Patches patches = make_patches(elements, edge, of);
            if (patches.list.size() > max_patches) continue;
            return {std::move(meshes), std::move(elements), std::move(patches), edge};
        }
    }
    double size = even;  // the scene's own triangles, in increasingly larger patches
    do out.patches = make_patches(out.elements, size, PatchesOf::all_parts);
    while (out.patches.list.size() > max_patches && (size *= 1.5) < 1e300);
    for (const geometry::FineMesh& mesh : out.meshes)
        for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) out.edge = std::max(out.edge, longest_edge(mesh, t));
    return out;
}

void cut_evenly(const std::vector<Part>& parts, std::vector<geometry::FineMesh>& meshes, double edge,
                std::uint64_t max_elements, Context& context) {
    for (int round = 0; round < max_rounds; ++round) {
        edge *= 0.8;
        std::vector<geometry::FineMesh> finer = meshes;
        if (!cut_longer(parts, finer, edge, max_elements, context)) return;
        if (count_sides(parts, finer) == count_sides(parts, meshes) && round > 8) return;
        meshes = std::move(finer);
    }
}

}  // namespace rakelight::radiosity
