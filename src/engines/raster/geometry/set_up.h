// SPDX-License-Identifier: Apache-2.0
// Triangles of a part of one draw: culled, clipped where they must be, on the screen, sorted by the tiles that they
// touch.
#pragma once
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "engines/raster/geometry/front_end.h"

namespace rakelight::raster {

inline constexpr std::size_t triangles_per_chunk = 4096;

/// Part of one draw. Chunks are cut by numbers of triangles, never by threads.
struct ChunkRange {
    std::size_t draw, first, end;  ///< triangles of the draw's mesh
};

/// Triangles of one chunk in one tile.
struct ChunkRun {
    std::uint32_t tile, first, count;  ///< first: into ChunkTriangles::sorted
    bool has_large;
};

/// What became of the triangles of a chunk; as in RenderStats.
struct TriangleCounts {
    std::uint32_t culled_back = 0, culled_degenerate = 0, culled_outside = 0, clipped = 0, drawn = 0;
};

/// What comes of a chunk: its triangles tile by tile, in each of them in the order of the scene.
struct ChunkTriangles {
    std::vector<const ScreenTriangle*> sorted;
    std::vector<ChunkRun> runs;
    bool hides_in_window = false;  ///< FrontEnd::culled_by_side
    TriangleCounts counts;
};

/// Memory for the rows of a picture, in blocks that threads take; the next picture uses them again. Thread-safe.
class RowBlocks {
public:
    static constexpr std::size_t block_rows = 8 * triangles_per_chunk;
    ScreenTriangle* take();
    void take_all_back() { next_ = 0; }

private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<ScreenTriangle[]>> blocks_;
    std::size_t next_ = 0;
};

/// Working memory of one thread.
struct SetUpScratch {
    ScreenTriangle *next_row = nullptr, *end_of_rows = nullptr;  ///< what is left of the block
    std::vector<std::uint32_t> tiles;                            ///< beside the kernel's rows
    struct Entry {
        std::uint32_t tile;
        const ScreenTriangle* row;
    };
    std::vector<Entry> entries;  ///< in the order of the scene; those past entry_count mean nothing
    std::size_t entry_count = 0;
    std::vector<std::uint32_t> count;    ///< [tiles] of entries; 0 between chunks
    std::vector<std::uint32_t> touched;  ///< tiles with entries, in the order of the first
};

/// What set-up keeps from picture to picture.
struct SetUpMemory {
    RowBlocks blocks;
    std::vector<ChunkTriangles> chunks;
    std::mutex mutex;  ///< of `free`
    std::vector<std::unique_ptr<SetUpScratch>> free;
};

/// Sets up the triangles of a chunk.
/// @throws Error bad_file where the picture's triangles need more than PictureMemory allows
void set_up_chunk(FrontEnd& front, const TileGrid& grid, const ChunkRange& range, RowBlocks& blocks,
                  SetUpScratch& scratch, ChunkTriangles& out);

}  // namespace rakelight::raster
