// SPDX-License-Identifier: Apache-2.0
// Blended surfaces of a tile, put in order pixel by pixel: surfaces that cross are right on both sides of where they do.
// They come triangle by triangle, roughly far to near. What nothing farther can follow is laid at once; the rest waits at
// its pixel, sorted by depth. This is the k-buffer (Bavoil et al. 2007, "Multi-fragment effects on the GPU using the
// k-buffer"): where one surface too many waits, the farthest is laid, so that the order is wrong only where a surface
// comes after more than `most_waiting` nearer ones, and none is lost.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "engines/raster/shade/layer_order.h"
#include "engines/raster/tile.h"

namespace rakelight::raster {

class MarkLayers;

/// What a triangle is at one pixel.
struct BlendedFragment {
    vec4 color;                    ///< linear, alpha 0..1
    float key;                     ///< depth at the pixel's center
    float reach;                   ///< its change up to the samples; 0 in pictures of one
    std::uint32_t number;          ///< of the triangle in the tile's list
    std::uint16_t pixel, samples;  ///< in the tile; a bit a sample
};

/// Working memory of BlendedLayers, used again by the next tile.
struct LayerScratch {
    struct Waiting {
        BlendedFragment fragment;
        std::uint32_t next;  ///< the next farther one of the pixel
    };
    std::vector<Waiting> waiting;
    std::vector<std::uint32_t> first = std::vector<std::uint32_t>(tile_pixels);  ///< nearest one of each pixel
    std::vector<std::uint8_t> count = std::vector<std::uint8_t>(tile_pixels);
    std::vector<LayerPlace> laid;  ///< [tile_pixels] the nearest that had to be laid early; empty: none had to
    std::vector<std::uint16_t> masks = std::vector<std::uint16_t>(tile_pixels);        ///< of a triangle; then 0 again
    std::vector<std::uint16_t> batch_masks = std::vector<std::uint16_t>(tile_pixels);  ///< beside the batch arrays
    std::vector<float> batch_reach = std::vector<float>(tile_pixels);
};

class BlendedLayers {
public:
    static constexpr std::size_t most_waiting = 32;  ///< at a pixel

    /// @param marks  lines and points between the surfaces; null: there are none
    BlendedLayers(const TileJob& job, std::size_t tile, TileScratch& scratch, MarkLayers* marks, int samples);
    BlendedLayers(const BlendedLayers&) = delete;
    BlendedLayers& operator=(const BlendedLayers&) = delete;
    ~BlendedLayers();

    /// @param floor  no depth key of what comes after is less
    /// @throws Error bad_file where what waits needs more than PictureMemory allows
    void add(const BlendedFragment& f, float floor) {
        if (m_.first[f.pixel] == no_index && f.key + f.reach < floor * (1 - 2 * equal_depths))
            lay(f);
        else
            wait(f);
    }
    /// Lays what waits.
    void finish();

private:
    const ScreenTriangle& triangle(std::uint32_t number) const { return *items_[number]; }
    void lay(const BlendedFragment& f);
    void wait(const BlendedFragment& f);
    void lay_farthest(const BlendedFragment& added);
    std::uint32_t place_for(const BlendedFragment& f);
    void finish_pixel(std::size_t pixel);
    void lay_by_samples(const BlendedFragment* const* fragments, std::size_t count);

    const TileJob& job_;
    TileScratch& s_;
    LayerScratch& m_;
    MarkLayers* const marks_;
    const ScreenTriangle* const* const items_;
    const int ox_, oy_;
    const std::size_t samples_;
    std::uint32_t free_ = no_index;  ///< a place in `waiting` that is unused
    std::uint64_t charged_ = 0;      ///< [bytes]
};

}  // namespace rakelight::raster
