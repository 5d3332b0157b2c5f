// SPDX-License-Identifier: Apache-2.0
// The triangle meshes of a scene, each placement by itself, as geometry takes them.
#pragma once
#include <span>
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/scene.h>

#include "prepare/variants.h"

namespace rakelight {

/// Part i is one placement of one mesh, skinned ones in bind pose. AttributeMesh::object counts in the list of objects.
/// The arrays are the scene's.
struct Surfaces {
    std::vector<Instance> parts;
    std::vector<AttributeMesh> meshes;  ///< [parts] with the file's normals, texture coordinates and smoothing groups
};

/// @param objects  the node of each object, ascending; all nodes that have meshes
Surfaces collect_surfaces(const Scene& scene, std::span<const std::uint32_t> objects);

}  // namespace rakelight
