// SPDX-License-Identifier: Apache-2.0
// Lines and points of one stretch of a mesh, or edges and vertices of its triangles: clipped, on the screen, with the
// tiles that they touch.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "engines/raster/marks/marks.h"

namespace rakelight::raster {

constexpr std::uint32_t no_color = no_index;

/// Which elements of a draw become marks.
enum class MarkSource : std::uint8_t { lines, points, edges, vertices };

struct MarkChunk {
    const Draw* draw = nullptr;
    MarkSource source = MarkSource::lines;
    std::uint32_t color = no_color;  ///< of all; no_color: the vertices' own, from first_color on
    std::uint32_t first_color = 0;
    std::size_t first = 0, end = 0;  ///< lines, points or triangles; at most marks_per_chunk
    std::vector<Mark> marks;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> tiles;  ///< (tile, index in `marks`)
};
inline constexpr std::size_t marks_per_chunk = 4096;

/// Fills `marks` and `tiles`. An edge that triangles of the chunk share is one mark, and so is a vertex.
/// @throws Error bad_file where they need more than PictureMemory allows
void set_up_marks(FrontEnd& front, const TileGrid& grid, MarkChunk& chunk);

}  // namespace rakelight::raster
