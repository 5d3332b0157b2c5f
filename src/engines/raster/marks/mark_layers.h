// SPDX-License-Identifier: Apache-2.0
// Marks of a tile that has blended surfaces: each is laid before the first of them that lies in front of it, so that
// glass tints what is behind it.
#pragma once
#include <cstdint>
#include <vector>

#include "engines/raster/marks/tile_marks.h"

namespace rakelight::raster {

/// The fragments of all marks, which wait at their pixels. What waits counts as memory of the picture.
class MarkLayers {
public:
    /// @throws Error bad_file where they need more than PictureMemory allows
    MarkLayers(const TileJob& job, std::size_t tile, TileScratch& scratch);
    MarkLayers(const MarkLayers&) = delete;
    MarkLayers& operator=(const MarkLayers&) = delete;
    ~MarkLayers();

    /// Lays those that are behind a blended triangle, on the `count` pixels (`pixel` of the scratch) where it comes
    /// next. A mark on the triangle is not behind it.
    void lay_behind(const ScreenTriangle& t, std::size_t count);
    /// The same on all samples of these pixels (SampleScratch::color).
    void lay_behind_samples(const ScreenTriangle& t, std::size_t count);
    /// The others over everything, on the pixels; and what data channels hold.
    void lay_rest();

private:
    struct Waiting {
        MarkFragment fragment;
        std::uint32_t next;  ///< of the same pixel
    };
    struct List {
        std::uint32_t first = no_index, last = no_index;  ///< into waiting_
    };

    void take(const MarkFragment& f);
    template <class ColorsOf>
    void lay_behind(const ScreenTriangle& t, std::size_t count, std::size_t samples, const ColorsOf& colors_of);
    template <class Chosen>
    void lay(std::size_t pixel, vec4* to, std::size_t samples, const Chosen& is_chosen);

    const TileJob& job_;
    TileScratch& s_;
    TileMarks marks_;
    int ox_, oy_;
    std::vector<List> lists_;  ///< [tile_pixels]
    std::vector<Waiting> waiting_;
    std::uint64_t charged_ = 0;  ///< [bytes]
};

}  // namespace rakelight::raster
