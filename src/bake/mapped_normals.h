// SPDX-License-Identifier: Apache-2.0
// The normal maps that a surface has itself.
#pragma once
#include <map>

#include "bake/map_reader.h"

namespace rakelight::bake {

/// Maps of materials whose normal maps act, in full size and linear between texels; with the frames of
/// src/lighting/relief/normal_map.glsl: unit normal, tangent perpendicular.
class MappedNormals {
public:
    /// A map that cannot be decoded is a warning, and left out.
    MappedNormals(const Scene& scene, Context& context);
    /// The unit normal that the map makes of `normal`, which it is where there is no map. @param mesh  of the scene
    dvec3 at(const dmat4& to_world, const Mesh& mesh, std::uint32_t triangle, const double (&weight)[3],
             dvec3 normal) const;

private:
    std::vector<Material> materials_;
    std::map<std::uint32_t, MapReader> maps_;  ///< by material
};

}  // namespace rakelight::bake
