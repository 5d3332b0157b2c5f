// SPDX-License-Identifier: Apache-2.0
// The texture coordinates to which the tangents of a mesh belong.
#pragma once
#include <rakelight/scene/scene.h>

#include "scene/materials/uv_matrix.h"

namespace rakelight {

/// Which meshes get tangents: those whose material has a normal or height texture, or all with texture coordinates.
enum class TangentNeed : std::uint8_t { none, where_needed, everywhere };

/// A set of the mesh, as the texture's transform turns and scales it (its offset changes no direction).
struct TangentCoordinates {
    std::uint32_t set = no_index;  ///< no_index: no tangents, or no such coordinates
    UvMatrix matrix{};
    bool exist() const { return set != no_index; }
    bool operator==(const TangentCoordinates&) const = default;
};

/// Those of tangent_texture(), else (`everywhere`) the first set.
TangentCoordinates tangent_coordinates(const Scene& scene, const Mesh& mesh, TangentNeed need);

/// [V] The mesh's own block where nothing is transformed. Empty: there are none.
Block<vec2> tangent_texcoords(const Mesh& mesh, const TangentCoordinates& coordinates);

}  // namespace rakelight
