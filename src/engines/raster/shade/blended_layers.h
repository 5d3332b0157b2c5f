// SPDX-License-Identifier: Apache-2.0
// Blended surfaces of a tile, put in order pixel by pixel: surfaces that cross are right on both sides of where they do.
// They come group by group, far to near (blend_groups.h). What nothing farther can follow is laid at once; the rest of a
// group waits at its pixels, to be sorted by depth. This is the k-buffer (Bavoil et al. 2007, "Multi-fragment effects on the GPU
// using the k-buffer"): where one surface too many waits, the farthest is laid, so that the order is wrong only where a
// surface comes after more than `most_waiting` nearer ones of its group, and none is lost.
#pragma once
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engines/raster/shade/layer_order.h"
#include "engines/raster/tile.h"
#include "engines/raster/visibility/coverage.h"

namespace rakelight::raster {

class MarkLayers;

/// What a triangle is at one pixel.
struct BlendedFragment {
    vec4 color;                    ///< linear, alpha 0..1
    LayerPlace place;              ///< at the pixel's center; the triangle's number in the tile's list
    std::uint16_t pixel, samples;  ///< in the tile; a bit a sample
};

/// What is sorted.
struct SortedLayer {
    LayerPlace place;
    std::uint32_t at;  ///< in the arrays of what waits
};

/// Working memory of BlendedLayers, used again by the next tile.
struct LayerScratch {
    struct Waiting {
        LayerPlace place;
        std::uint32_t next;  ///< what came before it at the pixel
        std::uint16_t pixel, samples;
    };
    std::vector<Waiting> waiting;  ///< as many places as there is room for
    std::vector<vec4> colors;      ///< of `waiting`, apart because sorting does not ask for them
    /// Where a triangle that waits is at the samples of a pixel.
    struct Plane : KeyPlane {
        float reach;  ///< change of the depth from a pixel's center to its samples
    };
    std::vector<Plane> planes;  ///< [triangle of the tile] pictures of several samples
    std::vector<std::uint16_t> pixels = std::vector<std::uint16_t>(tile_pixels);  ///< first those where something waits
    /// [tile_pixels] What came last; no_index where nothing waits, so everywhere between tiles.
    std::vector<std::uint32_t> last = std::vector<std::uint32_t>(tile_pixels, no_index);
    std::vector<std::uint16_t> count =
        std::vector<std::uint16_t>(tile_pixels);  ///< what waits, times its samples, if counted
    std::vector<LayerPlace> laid;  ///< [tile_pixels] the nearest that had to be laid early; empty: none had to
    std::vector<std::uint16_t> masks = std::vector<std::uint16_t>(tile_pixels);        ///< of a triangle; then 0 again
    std::vector<std::uint16_t> batch_masks = std::vector<std::uint16_t>(tile_pixels);  ///< beside the batch arrays
};

/// A triangle's pixels in the batch arrays of TileScratch, where their colors are, and depths of those that are to wait.
struct BatchPart {
    std::uint32_t number;  ///< of the triangle in the tile's list
    std::size_t begin, end;
};

class BlendedLayers {
public:
    /// At a pixel. Triangles beside each other at samples of their own are one surface.
    static constexpr std::size_t most_waiting = 32;

    /// @param marks  lines and points between the surfaces; null: there are none
    BlendedLayers(const TileJob& job, std::size_t tile, TileScratch& scratch, MarkLayers* marks, int samples);
    BlendedLayers(const BlendedLayers&) = delete;
    BlendedLayers& operator=(const BlendedLayers&) = delete;
    ~BlendedLayers();

    /// At once.
    void lay(const BatchPart& part);
    /// In the order of depths, at finish().
    /// @throws Error bad_file where what waits needs more than PictureMemory allows
    void wait(const BatchPart& part);
    /// Lays what waits.
    void finish();

private:
    const ScreenTriangle& triangle(std::uint32_t number) const { return *items_[number]; }
    int weight(std::uint16_t samples) const { return samples_ == 1 ? 1 : std::popcount(samples); }
    vec4* sample_colors(std::size_t pixel) const;
    template <class Take>
    void for_each_fragment(const BatchPart& part, const Take& take);
    void lay(const BlendedFragment& f);
    void make_room(std::size_t count);
    void wait_counted(const BatchPart& part);
    void lay_early(const BlendedFragment& added);
    BlendedFragment waiting(std::uint32_t at) const {
        const LayerScratch::Waiting& w = m_.waiting[at];
        return {m_.colors[at], w.place, w.pixel, w.samples};
    }
    std::span<const SortedLayer> sorted(std::size_t pixel, SortedLayer* end) const;
    void finish_plain(std::span<const std::uint16_t> pixels);
    void finish_pixel(std::size_t pixel);
    bool is_order_of_all_samples(std::span<const SortedLayer> layers) const;
    void lay_by_samples(std::span<const SortedLayer> layers);
    void clear();

    const TileJob& job_;
    TileScratch& s_;
    LayerScratch& m_;
    MarkLayers* const marks_;
    const ScreenTriangle* const* const items_;
    const int ox_, oy_;
    const std::size_t samples_;
    const bool is_plain_;            ///< nothing else asks what is laid
    std::size_t parts_ = 0;          ///< that wait; one has a pixel's sample once, so few of them need no counts
    std::size_t used_ = 0;           ///< of `waiting`
    std::size_t pixels_ = 0;         ///< where something waits
    std::uint32_t free_ = no_index;  ///< one of those, unused again
    std::uint64_t charged_ = 0;      ///< [bytes]
};

}  // namespace rakelight::raster
