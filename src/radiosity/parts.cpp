// SPDX-License-Identifier: Apache-2.0
#include "radiosity/parts.h"

#include <algorithm>
#include <cmath>

#include "math/linear.h"
#include "scene/placement.h"
#include "shading/choices.h"

namespace rakelight::radiosity {

std::vector<Part> lit_parts(const Scene& scene) {
    std::vector<Part> parts;
    const std::vector<dmat4> to_world = world_matrices(scene);
    for (const Instance& instance : drawn_instances(scene)) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        const Material& material = scene.materials[mesh.material];
        if (material.model == MaterialModel::unlit) continue;
        Part part{.instance = instance, .to_world = to_world[instance.node] * translation(mesh.origin)};
        part.is_mirrored = determinant(upper_left(part.to_world)) < 0;
        part.is_two_sided = shading::is_two_sided(material);
        part.material = mesh.material;
        parts.push_back(part);
    }
    return parts;
}

std::vector<geometry::FineMesh> placed_meshes(const Scene& scene, const std::vector<Part>& parts, Context& context) {
    std::vector<AttributeMesh> meshes;
    for (const Part& part : parts) {
        const Mesh& mesh = scene.meshes[part.instance.mesh];
        meshes.push_back({.object = part.instance.node,
                          .positions = mesh.positions,
                          .indices = mesh.indices,
                          .to_world = part.to_world,
                          .position_step = mesh.position_step});
    }
    std::vector<geometry::FineMesh> out;
    for (geometry::CoarseMesh& coarse : geometry::coarse_meshes(geometry::place_vertices(meshes, -1, context)))
        out.push_back(geometry::uncut(std::move(coarse)));
    return out;
}

std::uint64_t count_sides(const std::vector<Part>& parts, const std::vector<geometry::FineMesh>& meshes) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) count += parts[i].sides() * (meshes[i].indices.size() / 3);
    return count;
}

double longest_edge(const geometry::FineMesh& mesh, std::size_t triangle) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const dvec3 way =
            mesh.places[mesh.indices[3 * triangle + k]] - mesh.places[mesh.indices[3 * triangle + (k + 1) % 3]];
        longest = std::max(longest, dot(way, way));
    }
    return std::sqrt(longest);
}

}  // namespace rakelight::radiosity
