// SPDX-License-Identifier: Apache-2.0
#include "prepare/generated_attributes.h"

#include <algorithm>

#include "math/linear.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

/// [meshes] whether it is in an island with a moving mesh.
std::vector<bool> touched(const GeneratedAttributes& made) {
    std::vector<bool> island_moves(made.islands.size(), false), result;
    for (std::size_t i = 0; i < made.islands.size(); ++i)
        if (made.moves[i]) island_moves[made.islands[i]] = true;
    for (const std::uint32_t island : made.islands) result.push_back(island_moves[island]);
    return result;
}

/// The instances of a mesh in the posed scene.
struct Shown {
    std::uint32_t uses = 0, node = no_index;
};

std::vector<Shown> shown_meshes(const Scene& scene) {
    std::vector<Shown> shown(scene.meshes.size());
    for (std::uint32_t n = 0; n < scene.nodes.size(); ++n)
        for (const std::uint32_t mesh : scene.nodes[n].meshes) ++shown[mesh].uses, shown[mesh].node = n;
    return shown;
}

}  // namespace

void recompute_attributes(const GeneratedAttributes& made, Scene& posed, Context& context) {
    const std::vector<bool> is_touched = touched(made);
    if (std::ranges::none_of(is_touched, [](bool b) { return b; })) return;
    const std::vector<dmat4> world = world_matrices(posed);
    const std::vector<Shown> shown = shown_meshes(posed);
    std::vector<AttributeMesh> meshes = made.meshes;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const Mesh& mesh = posed.meshes[made.numbers[i]];
        // Vertices keep their indices; split ones are appended.
        meshes[i].positions = mesh.positions.span().first(meshes[i].positions.size());
        if (!meshes[i].normals.empty()) meshes[i].normals = mesh.normals.span().first(meshes[i].positions.size());
        const Shown& by = shown[made.numbers[i]];
        const std::uint32_t node = by.uses == 1 ? by.node : made.nodes[i];
        meshes[i].to_world = (made.in_world[i] ? world[node] : dmat4{}) * translation(mesh.origin);
    }
    std::vector<MeshAttributes> results = accumulate(made.plan, meshes, context);
    for (std::size_t i = 0; i < made.computed; ++i) {
        Mesh& mesh = posed.meshes[made.numbers[i]];
        if (!is_touched[i] || shown[made.numbers[i]].uses != 1 || results[i].normals.size() != mesh.positions.size())
            continue;
        mesh.normals = std::move(results[i].normals);
        if (results[i].tangents.size() == mesh.positions.size()) mesh.tangents = std::move(results[i].tangents);
    }
}

}  // namespace rakelight
