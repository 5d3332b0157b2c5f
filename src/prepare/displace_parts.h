// SPDX-License-Identifier: Apache-2.0
// What displacement has to do with each placement of a mesh: which height map, how deep.
#pragma once
#include <memory>
#include <vector>

#include <rakelight/prepare.h>
#include <rakelight/scene.h>

#include "prepare/height_field.h"
#include "prepare/variants.h"

namespace rakelight {

/// The mesh's material where it is to be displaced and has a height map, and the mesh texture coordinates for it.
const Material* displaced_material(const Scene& scene, const Mesh& mesh, const Displacement& options);

/// Its own, or that of the picture.
const Relief& relief_of(const Material& material, const Displacement& options);

/// A placement of a mesh, and what is made of it.
struct DisplacedPart {
    Instance instance;
    dmat4 to_world, to_object;           ///< with the mesh's origin
    const Material* material = nullptr;  ///< null: not displaced
    std::shared_ptr<const HeightField> heights;
    double depth = 0;           ///< [m] from the lowest to the highest point
    std::vector<float> blur;    ///< [V'] mip level at which the vertex reads its height
    std::vector<float> offset;  ///< [V'] m
};

/// All that is drawn, with depths: a depth of 1 is one width of the texture, which is one length for all that has the
/// material. Left out is what a matrix makes flat: it has no border to cut.
std::vector<DisplacedPart> collect_parts(const Scene& scene, const Displacement& options, Context& context);

/// Sets the mip levels of a part that is displaced.
/// Heights are read where texels are as large as the square whose diagonal is the longest edge at the vertex (cut
/// squares are such triangles): what is finer, vertices so far apart cannot hold, and would show as shapes that the map
/// has not.
/// @param fine  the part's mesh, cut
void set_blur(const Mesh& fine, DisplacedPart& part);

/// Once for each material whose relief is mostly finer than the triangles.
/// @param longest_edge  [m] of the triangles
void warn_of_lost_relief(const Scene& scene, const std::vector<DisplacedPart>& parts, double longest_edge,
                         Report& report);

}  // namespace rakelight
