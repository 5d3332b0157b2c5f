// SPDX-License-Identifier: Apache-2.0
// The normals of a model as they are, and after smoothing across all objects.
#pragma once
#include <span>
#include <string>
#include <vector>

#include <rakelight/geometry/attributes.h>
#include <rakelight/geometry/seams.h>
#include <rakelight/tools/inspect.h>

#include "tools/inspect/surfaces.h"

namespace rakelight {

/// The normals of one part: the file's, or computed.
struct PartNormals {
    std::span<const vec3> given;         ///< [V] by the mesh's own indices; empty: `made` counts
    std::vector<vec3> made;              ///< [V'] else
    std::vector<std::uint32_t> indices;  ///< [3T] into `made`; empty: the mesh's own

    /// The vertex that a corner (3 * triangle + k) uses for its normal.
    /// @param own  the mesh's indices
    std::uint32_t vertex(std::span<const std::uint32_t> own, std::size_t corner) const {
        return indices.empty() ? own[corner] : indices[corner];
    }
    vec3 normal(std::uint32_t vertex) const { return given.empty() ? made[vertex] : given[vertex]; }
};

struct SeamNormals {
    std::vector<PartNormals> before, after;  ///< [parts]
};

/// By the rules of the parts and the weight and crease angle of `options.prepare`; `options.weld_distance` what is one
/// place.
std::vector<PartNormals> normals_before(const Surfaces& surfaces, const InspectOptions& options, Context& context);

/// Whether some parts' smooth normals are made, because the file has none or they do not count.
bool makes_normals(const Surfaces& surfaces);

/// As `rakelight smooth` writes them with the same crease angle and weight: by `options.authored`, kept ones are joined
/// where parts meet, or all are smoothed over the model.
std::vector<PartNormals> normals_after(const Surfaces& surfaces, const InspectOptions& options, Context& context);

/// Some parts as meshes that have their normals; what these split is a vertex of its own. Views into both.
struct MeshesWithNormals {
    std::vector<AttributeMesh> meshes;
    std::vector<std::vector<vec3>> positions;  ///< of those that were split
};
MeshesWithNormals meshes_with_normals(const Surfaces& surfaces, std::span<const PartNormals> normals,
                                      std::span<const std::uint32_t> parts, Context& context);

/// Turns the normals of some parts.
/// @param turned  [parts] of the meshes that meshes_with_normals() made of them
void apply(const std::vector<MeshSeams>& turned, std::span<const std::uint32_t> parts,
           std::vector<PartNormals>& normals);

/// The source of the normals of normals_before(), for people: "the file's, smoothed per object where it has none (2 of
/// 5 meshes)".
std::string name_of_source(const Surfaces& surfaces);
/// That of normals_after().
std::string name_of_smoothing(const Surfaces& surfaces, const InspectOptions& options);

}  // namespace rakelight
