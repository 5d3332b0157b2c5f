// SPDX-License-Identifier: Apache-2.0
// The color of a material over a piece of surface: what it reflects diffusely and what it emits, textures averaged.
#pragma once
#include <map>
#include <memory>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/scene.h>

#include "image/convert.h"
#include "shading/mean_map.h"

namespace rakelight::radiosity {

/// The pictures that the materials of a scene read for color, as sums; those that cannot be decoded count as white (said in
/// the report by the engine that draws them). Immutable.
class ColorMaps {
public:
    ColorMaps(const Scene& scene, const std::vector<bool>& is_used, Context& context);
    /// Mean of the texture over a triangle's texture coordinates; white without one.
    /// @param corner  vertices of `mesh`
    dvec3 mean(const TextureUse& use, const Mesh& mesh, const std::uint32_t* corner) const;
    /// Share of a material's base color that is diffuse over a triangle; the rest is mirrored or goes through.
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
