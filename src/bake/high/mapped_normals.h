// SPDX-License-Identifier: Apache-2.0
// Normal maps of HIGH's materials.
#pragma once
#include <map>

#include "bake/high/map_reader.h"

namespace rakelight::bake {

/// Active normal maps of materials, in full size with bilinear filtering, in the frames of
/// src/lighting/relief/normal_map.glsl: unit normal, tangent perpendicular.
class MappedNormals {
public:
    /// Maps that cannot be decoded cause a warning and are ignored.
    MappedNormals(const Scene& scene, Context& context);
    /// The mapped unit normal; `normal` itself without a map.
    /// @param mesh of the scene
    dvec3 at(const dmat4& to_world, const Mesh& mesh, std::uint32_t triangle, const double (&weight)[3],
             dvec3 normal) const;

private:
    std::vector<Material> materials_;
    std::map<std::uint32_t, MapReader> maps_;  ///< by material
};

}  // namespace rakelight::bake
