// SPDX-License-Identifier: Apache-2.0
// Triangles of a part of one draw: culled, clipped where they must be, on the screen, sorted by the tiles that they
// touch.
#pragma once
#include <cstdint>
#include <vector>

#include "engines/raster/front_end.h"

namespace rakelight::raster {

inline constexpr std::size_t triangles_per_chunk = 4096;

/// Part of one draw. Chunks are cut by numbers of triangles, never by threads.
struct ChunkRange {
    std::size_t draw, first, end;  ///< triangles of the draw's mesh
};

/// Triangles of one chunk in one tile.
struct ChunkRun {
    std::uint32_t tile, first, count;  ///< first: into Binned::Chunk::rows
    bool has_large;
};

/// Working memory of one chunk; used again by the next one.
struct SetUpScratch {
    explicit SetUpScratch(std::size_t tiles) : count(tiles, 0) {}
    std::vector<ScreenTriangle> rows;
    std::vector<std::uint32_t> tiles;  ///< beside `rows`, of the kernel
    struct Entry {
        std::uint32_t tile, row;
    };
    std::vector<Entry> entries;          ///< in the order of the scene
    std::vector<std::uint32_t> count;    ///< [tiles] of entries; 0 between chunks
    std::vector<std::uint32_t> touched;  ///< tiles with entries, in the order of the first
};

/// Sets up the triangles of a chunk; what came of them is added to `stats`.
/// @throws Error bad_file where the picture's triangles need more than PictureMemory allows
void set_up_chunk(FrontEnd& front, const TileGrid& grid, const ChunkRange& range, SetUpScratch& scratch,
                  Binned::Chunk& chunk, std::vector<ChunkRun>& runs, RenderStats& stats);

}  // namespace rakelight::raster
