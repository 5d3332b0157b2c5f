// SPDX-License-Identifier: Apache-2.0
// A scene's environment as the kernels read it: made once for a picture of all around, kept while the scene uses it.
#pragma once
#include <memory>
#include <vector>

#include "engines/raster/shade/tile.h"
#include "engines/raster/textures/textures.h"
#include "image/environment.h"

namespace rakelight::raster {

/// What is made of the picture alone. Not to be copied: views point into it.
struct EnvironmentMaps {
    EnvironmentMaps() = default;
    EnvironmentMaps(const EnvironmentMaps&) = delete;
    EnvironmentMaps& operator=(const EnvironmentMaps&) = delete;

    ImageHandle image;  ///< null: the studio
    std::shared_ptr<const TextureData> sky;
    std::vector<float> mirrored;
    TextureView sky_view, mirrored_view;
    std::array<vec3, 9> irradiance;
};

class EnvironmentCache {
public:
    /// The scene's environment for the list's pictures; nothing where it has none, or where its picture cannot be
    /// decoded: that is a warning in the report.
    void update(DrawList& list, Context& context);

private:
    std::shared_ptr<const EnvironmentMaps> maps_;
};

/// The background of pictures of this list is the environment.
bool has_sky(const DrawList& list);
/// The environment's picture at every pixel of a tile. @param color  [tile_pixels]
void fill_sky(const TileJob& job, std::size_t tile, std::vector<vec4>& color, TileScratch& scratch);

}  // namespace rakelight::raster
