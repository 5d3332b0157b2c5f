// SPDX-License-Identifier: Apache-2.0
// Says when a shadow map is coarse: when its texels are much larger than the pixels of what the picture shows.
#pragma once
#include <span>
#include <vector>

#include "engines/raster/kernels/kernel_types.h"
#include "engines/raster/tile.h"

namespace rakelight::raster {

/// Places that a picture shows, a few of each tile, and how large the lights' texels are there. One per picture.
class ShadowTexels {
public:
    /// [px] a texel that is as wide over a quarter of the places is worth a warning: an edge is blurred over
    /// 2 shadow_filter + 1 of them, 24 pixels by default.
    static constexpr double wide = 8;

    explicit ShadowTexels(const TileGrid& grid);

    /// After visibility. Tiles may be taken in any order, by several threads at once.
    void take(const TileJob& job, std::size_t tile, const TileScratch& scratch);

    /// One line about the light with the widest texels: a warning where they are `wide`, else a note. None without
    /// maps. Not of places beyond a light's range or beside a spot's map.
    /// @param lights  about the eye, as shaded
    /// @param maps    that their `shadow` numbers
    void remark(const Scene& scene, std::span<const lighting::LightParameters> lights, const ShadowView* maps,
                Context& context) const;

private:
    struct Place {
        dvec3 from_eye;          ///< [m] axes of the world
        double pixel_width = 0;  ///< [m] there; 0: nothing is seen
    };
    static constexpr int a_side = 4;  ///< of the lattice of places in a tile
    static constexpr std::size_t most_tiles = 256;

    /// [px] and [m] of the texels that a quarter of the places exceeds; 0: none of them is on the map.
    struct Width {
        double pixels = 0, meters = 0;
    };
    Width width_of(const ShadowView& map, double inverse_range) const;

    std::size_t step_;           ///< one tile of so many is looked at
    std::vector<Place> places_;  ///< [tiles that are][a_side * a_side]
};

}  // namespace rakelight::raster
