// SPDX-License-Identifier: Apache-2.0
// Colors of unlit surfaces.
#pragma once
#include <map>

#include "bake/high/map_reader.h"

namespace rakelight::bake {

class SurfaceColors {
public:
    /// Pictures that cannot be decoded are white, with a warning.
    SurfaceColors(const Scene& scene, Context& context);

    /// Base color times texture times vertex color, linear RGB.
    /// @param mesh     of the scene
    /// @param corner   [3] vertices of a triangle
    /// @param samples number of samples of the triangle, which selects the mip level
    dvec3 at(const Mesh& mesh, const std::uint32_t* corner, const double (&weight)[3], double samples) const;

private:
    const std::vector<Material>& materials_;
    std::map<std::uint32_t, MapReader> maps_;  ///< by material
};

}  // namespace rakelight::bake
