// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion of a picture: the depths of all its pixels before any is shaded, then openness tile by tile
// (lighting/occlusion/horizons.glsl). A window or a strip of rows has the depths of a guard band around it, as far as pixels
// are looked at, so that its pixels are those of the whole picture.
#pragma once
#include <optional>
#include <vector>

#include "engines/raster/geometry/front_end.h"
#include "engines/raster/kernels/occlusion_types.h"
#include "engines/raster/tile.h"

namespace rakelight::raster {

/// [px] as far as a pixel's occlusion is looked for, at most: a third of the picture's height, and 512.
int occlusion_reach(const RenderSettings& settings);

/// [m] RenderSettings::ambient_occlusion_radius, or its default in a scene of these bounds.
double occlusion_radius(const RenderSettings& settings, const Bounds& bounds);

class AmbientOcclusion {
public:
    /// @param front, binned  of the picture; they stay, and are used again where the guard band lies in its window
    AmbientOcclusion(const FrontEnd& front, const Binned& binned, const TileGrid& grid, const Kernels& kernels,
                     Context& context);
    AmbientOcclusion(const AmbientOcclusion&) = delete;
    AmbientOcclusion& operator=(const AmbientOcclusion&) = delete;

    /// The depths that some rows of the window, those of `strip`, need. Before find() of their tiles.
    void draw_depths(const Window& strip, Context& context);

    /// Openness of a tile's pixels, and of one more to each side, into its scratch; the data channel, where it is requested.
    void find(const TileJob& job, std::size_t tile, TileScratch& scratch) const;

    /// Gives a batch the openness of its pixels; `job.count` of TileScratch::pixel.
    void give(ShadeJob& job, TileScratch& scratch) const;
    /// The same of what triangles show of pixels at edges, where another surface may be at the center: that of the nearest pixel
    /// which shows theirs.
    void give_to_fragments(ShadeJob& job, int origin_x, int origin_y, TileScratch& scratch) const;

private:
    void set_factors(const PictureCamera& view);
    void find(const Window& area, int origin_x, int origin_y, TileScratch& scratch) const;
    float key_at(int x, int y) const;
    float best_around(int x, int y, int px, int py, const ShadeTriangle& triangle, const TileScratch& scratch) const;

    const PictureCamera& view_;
    const FrontEnd* front_;  ///< what depths are drawn of: the picture's, or `guard_`
    const Binned* binned_;
    TileGrid grid_;
    const GeometryKernels& geometry_;
    const Kernels& kernels_;
    RenderSettings settings_;  ///< of the guard band
    std::optional<FrontEnd> guard_;
    Binned guard_binned_;
    OcclusionJob factors_{};
    std::vector<float> cosines_, sines_;
    Window area_{};  ///< [px] of `keys_`, without margins
    std::size_t stride_ = 0;
    std::vector<float> keys_;
    MemoryCharge charge_;
};

}  // namespace rakelight::raster
