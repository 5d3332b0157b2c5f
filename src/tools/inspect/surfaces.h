// SPDX-License-Identifier: Apache-2.0
// The triangle meshes of a scene, each placement by itself, as geometry takes them.
#pragma once
#include <span>
#include <vector>

#include <rakelight/geometry/attributes.h>
#include <rakelight/scene/scene.h>

#include "prepare/normals/normal_rule.h"
#include "prepare/variants.h"

namespace rakelight {

/// Part i is one placement of one mesh, skinned ones in bind pose. AttributeMesh::object counts in the list of objects.
/// The arrays are the scene's, but for texture coordinates that a transform changes.
struct Surfaces {
    std::vector<Instance> parts;
    std::vector<AttributeMesh> meshes;   ///< [parts] with the file's normals, texture coordinates and smoothing groups
    std::vector<Block<vec2>> texcoords;  ///< [parts] behind their transforms
    std::vector<NormalRule> rules;       ///< [parts] by which the normals of a picture come about
};

/// Whether any part has normals of its own, and its rule keeps them.
bool keep_some(const Surfaces& surfaces);

/// @param objects  the node of each object, ascending; all nodes that have meshes
/// @param source  whose normals the picture would have. `automatic`, in scenes of which no part has a choice: what is
///                not in the file is smoothed per object, as programs do that see no borders
Surfaces collect_surfaces(const Scene& scene, std::span<const std::uint32_t> objects, NormalSource source);

}  // namespace rakelight
