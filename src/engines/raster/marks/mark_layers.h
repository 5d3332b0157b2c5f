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

    /// Some lie at a pixel, laid or not.
    bool has_any(std::size_t pixel) const { return has_any_[pixel] != 0; }
    /// Lays those that are behind a blended triangle at a pixel where it comes next, on all samples of the pixel. A mark
    /// on the triangle is not behind it.
    void lay_behind(const ScreenTriangle& t, std::size_t pixel, vec4* colors, std::size_t samples);
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
    template <class Chosen>
    void lay(std::size_t pixel, vec4* to, std::size_t samples, const Chosen& is_chosen);

    const TileJob& job_;
    TileScratch& s_;
    TileMarks marks_;
    int ox_, oy_;
    std::vector<List> lists_;            ///< [tile_pixels]
    std::vector<std::uint8_t> has_any_;  ///< [tile_pixels]
    const ScreenTriangle* last_ = nullptr;
    SurfacePlane plane_;  ///< of last_
    std::vector<Waiting> waiting_;
    std::uint64_t charged_ = 0;  ///< [bytes]
};

}  // namespace rakelight::raster
