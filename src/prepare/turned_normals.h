// SPDX-License-Identifier: Apache-2.0
// Some normals of placements turn: what <rakelight/seams.h> and <rakelight/matching_borders.h> are given, and where their
// results go.
#pragma once
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/scene.h>
#include <rakelight/seams.h>

#include "prepare/variants.h"

namespace rakelight {

/// The placements that take part.
struct PlacedParts {
    std::vector<Instance> instances;
    std::vector<AttributeMesh> meshes;  ///< [instances] with their normals; the spans point into the scene

    /// @param place  of the node: object -> world
    void add(const Instance& instance, const Mesh& mesh, const dmat4& place);
    /// Of the lists, before they are made longer by results.
    void check_memory(Context& context) const;
};

/// The scene with the turned normals. Tangents are those of MeshSeams::tangents, or turn along; the offsets of morph targets
/// turn along. Arrays that several meshes share go on being shared where that can be; placements of one mesh that come out
/// differently get a mesh of their own, and it is said.
/// @param keep_instances  they go on sharing it, with the normals of the first; said
/// @param turned  [parts]
Scene with_turned_normals(Scene scene, const PlacedParts& parts, std::vector<MeshSeams> turned, bool keep_instances,
                          Context& context);

}  // namespace rakelight
