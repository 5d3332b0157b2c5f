// SPDX-License-Identifier: Apache-2.0
// Multisampling: visibility at several samples of a pixel, shading once for each triangle that they show. A pixel whose
// samples all show one triangle is shaded as without; the samples of the others have colors of their own until they are
// averaged, in linear light.
#pragma once
#include <cstdint>
#include <vector>

#include "engines/raster/tile.h"
#include "shading/sample_positions.h"

namespace rakelight::raster {

using shading::SamplePosition, shading::fixed_per_position, shading::mean_of_samples, shading::sample_positions;

/// What is seen at one place of every pixel of a tile. [tile_pixels] each, as in TileScratch.
struct SamplePlane {
    SamplePosition at;
    float* depth;
    std::int32_t* visible;
};

/// What one triangle shows of one pixel.
struct Fragment {
    std::int32_t position;         ///< in the tile's list
    std::uint16_t pixel, samples;  ///< in the tile; a bit a sample
};

/// Working memory of a multisampled tile.
struct SampleScratch {
    std::vector<float> depth;           ///< [samples][tile_pixels] of SamplePlane
    std::vector<std::int32_t> visible;  ///< the same
    /// [tile_pixels] position in the tile's list of what all samples show; -1: the background, `is_open`: several
    /// things
    std::vector<std::int32_t> whole = std::vector<std::int32_t>(tile_pixels);
    std::vector<std::int32_t> open_pixels;  ///< whose samples have colors of their own
    std::vector<std::int32_t> number = std::vector<std::int32_t>(tile_pixels);  ///< of the pixel among those
    std::vector<vec4> color;                                                    ///< [open_pixels][samples] linear
    std::vector<Fragment> found, fragments;  ///< of the open pixels; sorted by position
    std::vector<std::uint32_t> first;        ///< [list + 1] into `fragments`
    std::vector<vec4> resolved;              ///< [open_pixels]
    std::vector<std::uint32_t> codes;        ///< the same as sRGB
    bool blends = false;                     ///< something is to be laid over the tile's surfaces
};
inline constexpr std::int32_t is_open = -2;

/// A triangle as it lies about a sample when that is taken for the pixel's center.
inline ScreenTriangle seen_from(SamplePosition at, const ScreenTriangle& s) {
    ScreenTriangle moved = s;
    const int dx = at.x * fixed_per_position, dy = at.y * fixed_per_position;
    moved.x0 -= dx, moved.x1 -= dx, moved.x2 -= dx;
    moved.y0 -= dy, moved.y1 -= dy, moved.y2 -= dy;
    return moved;
}

/// Evaluates the pixels of a batch at the place of a sample.
void move_to(SamplePosition at, std::size_t count, ShadeJob& batch, TileScratch& scratch);
/// Evaluates a pixel of a batch at the centroid of its samples that show the triangle.
/// @param samples  1 << sample for each; all of them: the center
void move_to_middle(int samples, std::uint32_t sample_mask, std::size_t i, TileScratch& scratch);
/// [px] the same for one pixel, from its center.
vec2 middle_of(int samples, std::uint32_t sample_mask);
/// Makes `batch` use the offsets that move_to_middle() wrote.
void use_offsets(ShadeJob& batch, TileScratch& scratch);

/// find_visible() at one place of every pixel.
void find_visible_at(const SamplePlane& plane, const TileJob& job, std::size_t tile, TileScratch& scratch);

/// The stages of a tile in multisampled pictures. Data channels, and what lines and points ask, are of the pixels'
/// centers: a pass of its own, the same as in a picture of one sample.
void find_visible_samples(const TileJob& job, std::size_t tile, TileScratch& scratch);
void shade_samples(const TileJob& job, std::size_t tile, TileScratch& scratch);
void finish_samples(const TileJob& job, std::size_t tile, TileScratch& scratch);

}  // namespace rakelight::raster
