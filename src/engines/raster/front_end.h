// SPDX-License-Identifier: Apache-2.0
// The geometry stages: object space -> clip space -> clipping -> screen -> back-face culling -> bins of tiles.
#pragma once
#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include <rakelight/engine.h>

#include "engines/raster/clip.h"
#include "engines/raster/draw_list.h"

namespace rakelight::raster {

inline constexpr int subpixel_bits = 8;  ///< screen coordinates are integers of 1/256 pixel

/// A triangle, or a piece of one that was clipped, on the screen: counter-clockwise as seen with y down means positive
/// area. Its corners are ordered so that the area is positive: corner k is the mesh's corner k, or 2 and 1 are swapped.
struct ScreenTriangle {
    std::int32_t x0, y0, x1, y1, x2, y2;  ///< [1/256 px]
    double depth_x, depth_y, depth_0;     ///< depth key at (x, y) in px: greater is nearer
    float depth_low, depth_high;          ///< keys of the triangle's corners: the plane is clamped to them
    std::uint32_t draw, triangle;         ///< which mesh at which place, which triangle of it
    bool is_back;                         ///< seen from behind
    bool is_piece;                        ///< what clipping left: its corners are not the mesh's
    bool is_swapped;                      ///< corner 1 is the mesh's corner 2 and the other way round
    std::int32_t x(std::size_t corner) const { return corner == 0 ? x0 : corner == 1 ? x1 : x2; }
    std::int32_t y(std::size_t corner) const { return corner == 0 ? y0 : corner == 1 ? y1 : y2; }
};

/// Where a draw's vertices are in clip space, [vertices].
using ClipVertices = std::vector<ClipVertex>;

/// A vertex on the screen, [1/256 px].
struct ScreenPoint {
    std::int32_t x, y;
};

/// The tiles of a picture that a window touches.
struct TileGrid {
    TileGrid(int width, int height, Window window);
    int first_x, first_y, columns, rows;  ///< in tiles
    Window window;
    std::size_t count() const { return std::size_t(columns) * std::size_t(rows); }
    /// The pixels of tile i that lie in the window.
    Window pixels(std::size_t i) const;
    int origin_x(std::size_t i) const { return (first_x + int(i % std::size_t(columns))) * tile_size; }
    int origin_y(std::size_t i) const { return (first_y + int(i / std::size_t(columns))) * tile_size; }
};

/// All triangles of a picture, set up and sorted into tiles, in the order of the scene whatever the number of threads.
struct Binned {
    std::vector<std::vector<ScreenTriangle>> chunks;
    std::vector<std::uint32_t> offsets;                                       ///< [tiles + 1] into items
    std::vector<std::uint64_t> items;                                         ///< chunk << 32 | index in the chunk
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> spare;  ///< [chunks] memory for the next picture
    const ScreenTriangle& at(std::uint64_t item) const { return chunks[item >> 32][item & 0xFFFFFFFFu]; }
};

/// What the geometry of one picture takes. A file of a megabyte can place ten thousand instances of a mesh, or a million
/// triangles that each fill the picture: half of what files may ask for (MemoryBudget) bounds it. Thread-safe.
class PictureMemory {
public:
    explicit PictureMemory(const MemoryBudget& budget) : limit_(budget.limit() / 2) {}
    /// @throws Error bad_file where the sum passes the limit
    void add(std::uint64_t bytes);

private:
    std::uint64_t limit_;
    std::atomic<std::uint64_t> used_{0};
};

struct FrontEnd {
    const DrawList& list;
    const View& view;
    const RenderSettings& settings;
    std::vector<ClipVertices> clip;      ///< [draws]; empty for draws wholly outside
    std::vector<std::vector<ScreenPoint>>
        screen;  ///< [draws][vertices]; means nothing where a cutting plane is violated
    std::vector<std::vector<std::uint16_t>>
        codes;                           ///< [draws][vertices] planes that each vertex violates; empty: none does
    std::vector<dmat4> to_eye;           ///< [draws] object -> world axes about the eye
    RenderStats stats;
    PictureMemory memory;
};

/// The place of a vertex on the screen; what is not in the guard band stops at its rim.
ScreenPoint snap_to_screen(const View& view, const ClipVertex& v);

/// Matrices and clip-space vertices of every draw that may be seen.
void transform_draws(FrontEnd& front, Context& context);
/// Triangles into tiles.
/// @param used  what the picture before left: only its memory counts
Binned set_up_and_bin(FrontEnd& front, const TileGrid& grid, Binned&& used, Context& context);

/// Homogeneous edge functions of a triangle about a pixel position: e_i(x, y) = ex[i] x + ey[i] y + e0[i], in px from (x0, y0);
/// their sum is 1 / w, so b_i = e_i / sum (Olano & Greer 1997, "Triangle scan conversion using 2D homogeneous coordinates").
/// False when the triangle is seen exactly from its edge.
struct EdgePlanes {
    double ex[3], ey[3], e0[3];
};
bool edge_planes(const ClipVertex (&v)[3], const View& view, double x0, double y0, EdgePlanes& out);

}  // namespace rakelight::raster
