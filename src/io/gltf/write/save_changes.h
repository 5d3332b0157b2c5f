// SPDX-License-Identifier: Apache-2.0
// What new normals and tangents of a scene change in the glTF file, or document, that it came from.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <rakelight/base/report.h>
#include <rakelight/scene/scene.h>

#include "io/gltf/write/save_placements.h"
#include "io/gltf/write/save_storage.h"

namespace rakelight::io::gltf {

/// Which meshes and primitives change.
struct SceneChanges {
    std::vector<MeshVersion> versions;
    std::vector<std::uint32_t> origin;  ///< [meshes of the scene after] see origins()
    std::vector<bool> changed;          ///< [meshes of the scene after] by any bit
    /// Some difference is more than rounding, or a mesh is added. False: nothing is to be written, so that a second run over what the
    /// first wrote changes nothing.
    bool any = false;
    std::map<std::uint32_t, std::size_t> versions_of;  ///< by the file's mesh
};

SceneChanges find_changes(const Scene& before, const Scene& after, const DirectionStorage& storage, bool keep_instances,
                          Context& context);

/// How one primitive changes: it gets the normals, tangents, bitangents and targets of the mesh after.
struct PrimitiveChange {
    std::vector<std::uint32_t> copied;  ///< [vertices added] the vertex that each copies, with all its attributes
    std::vector<MorphTarget> targets;   ///< [targets] arrays that are the file's own are left out
    DirectionTypes types;               ///< of what is written
    bool corners = false;           ///< as a list of triangles: the corners of strips and fans cannot be distinguished
    bool widened = false;           ///< integers of 8 bits become float
    bool tangents_removed = false;  ///< the file's tangents go: nothing to make new ones from, or not wanted
    bool keeps_target_normals = false;  ///< of morph targets without new ones: offsets from normals that are no more
};

/// @param mesh  of `before`
PrimitiveChange change_of(std::uint32_t mesh, const Mesh& before, const Mesh& after, const DirectionStorage& storage);

/// What a user should know of it.
void report_change(const PrimitiveChange& change, const std::string& source, const std::string& place, Report& report);

}  // namespace rakelight::io::gltf
