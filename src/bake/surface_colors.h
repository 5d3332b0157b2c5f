// SPDX-License-Identifier: Apache-2.0
// What unlit surfaces show.
#pragma once
#include <map>

#include "bake/map_reader.h"

namespace rakelight::bake {

class SurfaceColors {
public:
    /// A picture that cannot be decoded counts as white, with a warning.
    SurfaceColors(const Scene& scene, Context& context);

    /// Base color times its texture times the vertices' colors, linear RGB.
    /// @param mesh     of the scene
    /// @param corner   [3] vertices of a triangle
    /// @param samples  by which the triangle is read in all: they decide how fine its texture is read
    dvec3 at(const Mesh& mesh, const std::uint32_t* corner, const double (&weight)[3], double samples) const;

private:
    const std::vector<Material>& materials_;
    std::map<std::uint32_t, MapReader> maps_;  ///< by material
};

}  // namespace rakelight::bake
