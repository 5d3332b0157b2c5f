// SPDX-License-Identifier: Apache-2.0
// Height map and depth of displacement for each instance of a mesh.
#pragma once
#include <memory>
#include <vector>

#include <rakelight/prepare/prepare.h>
#include <rakelight/scene/scene.h>

#include "prepare/refine/height_field.h"
#include "prepare/variants.h"

namespace rakelight {

/// The material of a displaced mesh with a height map and texture coordinates for it; else null.
const Material* displaced_material(const Scene& scene, const Mesh& mesh, const Displacement& options);

/// Its own relief, or the picture's.
const Relief& relief_of(const Material& material, const Displacement& options);

/// An instance of a mesh, and its result.
struct DisplacedPart {
    Instance instance;
    dmat4 to_world, to_object;           ///< with the mesh's origin
    const Material* material = nullptr;  ///< null: not displaced
    std::shared_ptr<const HeightField> heights;
    double depth = 0;           ///< [m] from the lowest to the highest point
    std::vector<float> blur;    ///< [V'] mip level of the vertex' height sample
    std::vector<float> offset;  ///< [V'] m
};

/// All drawn instances with depths: a depth of 1 is one width of the texture, which is one length for all instances
/// with the material. Instances with singular matrices are skipped.
std::vector<DisplacedPart> collect_parts(const Scene& scene, const Displacement& options, Context& context);

/// Sets the mip levels of a displaced part. Heights are read at the level whose texels are as large as the square whose
/// diagonal is the longest edge at the vertex. Finer details cannot be represented by the vertices and would alias.
/// @param fine the part's tessellated mesh
void set_blur(const Mesh& fine, DisplacedPart& part);

/// Warns once for each material whose relief is mostly finer than the triangles.
/// @param longest_edge  [m] of the triangles
void warn_of_lost_relief(const Scene& scene, const std::vector<DisplacedPart>& parts, double longest_edge,
                         Report& report);

}  // namespace rakelight
