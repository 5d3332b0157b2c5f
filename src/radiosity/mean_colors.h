// SPDX-License-Identifier: Apache-2.0
// Mean diffuse reflectance and emission of a material over a piece of surface.
#pragma once
#include <map>
#include <memory>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "image/convert.h"
#include "shading/lights/mean_map.h"

namespace rakelight::radiosity {

/// Summed-area tables of the color textures of a scene. Pictures that cannot be decoded are white (the engine reports
/// them). Immutable.
class ColorMaps {
public:
    ColorMaps(const Scene& scene, const std::vector<bool>& is_used, Context& context);
    /// Mean of the texture over a triangle's texture coordinates; white without one.
    /// @param corner  vertices of `mesh`
    dvec3 mean(const TextureUse& use, const Mesh& mesh, const std::uint32_t* corner) const;
    /// Diffuse share of a material's base color over a triangle; the rest is specular or transmitted.
    double diffuse_share(const Material& material, const Mesh& mesh, const std::uint32_t* corner) const;

private:
    struct Map {
        shading::MeanMap means;
        Sampler sampler;
    };
    void add(const Scene& scene, const TextureUse& use, ColorSpace space, Context& context);
    std::map<std::uint32_t, Map> maps_;  ///< by texture of the scene
    MemoryCharge charge_;
};

}  // namespace rakelight::radiosity
