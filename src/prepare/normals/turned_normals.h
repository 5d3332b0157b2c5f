// SPDX-License-Identifier: Apache-2.0
// Inputs of <rakelight/geometry/seams.h> and <rakelight/geometry/matching_borders.h>, and placement of the rotated normals.
#pragma once
#include <vector>

#include <rakelight/geometry/attributes.h>
#include <rakelight/geometry/seams.h>
#include <rakelight/scene/scene.h>

#include "prepare/variants.h"

namespace rakelight {

/// The instances to process.
struct PlacedParts {
    std::vector<Instance> instances;
    std::vector<AttributeMesh> meshes;  ///< [instances] with their normals; the spans point into the scene

    /// @param place  of the node: object -> world
    void add(const Instance& instance, const Mesh& mesh, const dmat4& place);
    /// [bytes] of the lists, without results.
    void check_memory(Context& context) const;
};

/// The scene with the rotated normals. Tangents are those of MeshSeams::tangents, or rotate with the normals, as
/// offsets of morph targets do. Arrays stay shared if possible. Instances with different results get meshes of their
/// own, which is reported.
/// @param keep_instances instances stay shared, with the normals of the first; reported
/// @param turned  [parts]
Scene with_turned_normals(Scene scene, const PlacedParts& parts, std::vector<MeshSeams> turned, bool keep_instances,
                          Context& context);

}  // namespace rakelight
