// SPDX-License-Identifier: Apache-2.0
// The instances that exchange light: triangle meshes without unlit materials.
#pragma once
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "geometry/refine/tessellate.h"
#include "prepare/variants.h"

namespace rakelight::radiosity {

struct Part {
    Instance instance;
    dmat4 to_world;  ///< with the mesh's origin
    bool is_mirrored = false;
    bool is_two_sided = false;
    std::uint32_t material = no_index;
    std::uint32_t sides() const { return is_two_sided ? 2 : 1; }
};

/// @param scene  every mesh has a material
std::vector<Part> lit_parts(const Scene& scene);

/// [parts] with bit-equal world positions for common vertices of any parts.
std::vector<geometry::FineMesh> placed_meshes(const Scene& scene, const std::vector<Part>& parts, Context& context);

/// Number of triangle sides.
std::uint64_t count_sides(const std::vector<Part>& parts, const std::vector<geometry::FineMesh>& meshes);

/// [m] of a triangle in world space.
double longest_edge(const geometry::FineMesh& mesh, std::size_t triangle);

}  // namespace rakelight::radiosity
