// SPDX-License-Identifier: Apache-2.0
// Plain data between the geometry and visibility stages and their kernels. Included by sources that are compiled once
// per instruction set: C headers only, no functions, so that the linker has nothing to merge.
#pragma once
#include <stdint.h>

namespace rakelight::raster {

inline constexpr int tile_size = 64;     ///< [px] side of a tile; tiles lie on the picture's own grid, not the window's
inline constexpr int tile_bits = 6;      ///< log2 of it
inline constexpr int block_side = 4;     ///< [px] of the blocks in whose order pixels are shaded
inline constexpr int subpixel_bits = 8;  ///< screen coordinates are integers of 1/256 pixel
inline constexpr int row_padding = 15;   ///< arrays that kernels load whole vectors from reach this far past their end
inline constexpr int small_extent =
    1 << 15;  ///< [1/256 px] kernels take triangles smaller than this: their edge functions fit 32 bits

/// A vertex on the screen: where triangles are cut out of pixels, and by how much that is beside its true place, which
/// the planes of the depth keys go through.
struct ScreenVertex {
    int32_t x, y;  ///< [1/256 px]; 0 where a cutting plane is violated: clipping looks at ClipVertex
    float key;  ///< depth key, 0..1: greater is nearer. Near / distance in perspective, else the rest of the way to the
                ///< far plane
    uint32_t bits;  ///< outcode(), 0 inside; then fine x and fine y
};
inline constexpr int outcode_bits = 10, fine_bits = 11;  ///< fine x: true x = x + (fine x / 2048 - 1/2) / 256 px

/// A triangle, or a piece of one that was clipped, on the screen. Its corners are ordered so that the area is positive
/// (y down): corner k is the mesh's corner k, or 2 and 1 are swapped. Begins with three ScreenVertex.
struct alignas(64) TriangleRow {
    int32_t x0, y0;  ///< [1/256 px]
    float key0;
    uint32_t bits0;
    int32_t x1, y1;
    float key1;
    uint32_t bits1;
    int32_t x2, y2;
    float key2;
    uint32_t bits2;
    uint32_t draw;      ///< which mesh at which place
    uint32_t triangle;  ///< of the mesh
    bool is_back;       ///< seen from behind
    bool is_piece;      ///< what clipping left: its corners are not the mesh's
    bool is_swapped;    ///< corner 1 is the mesh's corner 2 and the other way round
    bool is_large;      ///< small_extent wide or high
};
static_assert(sizeof(TriangleRow) == 4 * sizeof(ScreenVertex));

/// Vertices of one draw: object space -> clip space -> screen.
struct VertexJob {
    const float* positions;  ///< [3 * count]
    int32_t count;
    int32_t total;        ///< vertices that may be read from `positions`
    float to_clip[3][4];  ///< object space -> clip x, y and the distance along the view axis
    int32_t orthographic;
    float z_near, z_far;                          ///< limits of the distance: inside is near <= distance <= far
    float guard_x, guard_y;                       ///< limits of |x| / w, |y| / w that are not cut
    double scale_x, offset_x, scale_y, offset_y;  ///< x / w -> screen, see snap_to_screen()
    double key_scale, key_offset;                 ///< key = scale / w or offset + scale * distance
    float* clip;                                  ///< [4 * count + padding] out: x, y, w, distance
    ScreenVertex* screen;                         ///< [count + padding] out
};

/// What to do with a triangle that SetUpJob lets pass, where it is not the number of a tile.
inline constexpr uint32_t in_many_tiles = 0xffffffffu,
                          to_be_cut = 0xfffffffeu;  ///< to_be_cut: or is large; only `triangle` is set

/// Triangles of one draw: culled, or ready for the tiles.
struct SetUpJob {
    const uint32_t* indices;  ///< [3 * count]
    int32_t count;
    uint32_t first, draw;  ///< number of the first triangle in its mesh; of the draw
    const ScreenVertex* vertices;
    int32_t cull_back, cull_front, front_is_negative;  ///< front faces have negative area
    int32_t left, top, right, bottom;                  ///< [px] of the window, inclusive
    int32_t reach;  ///< [1/256 px] how far from a pixel's center samples lie: 0 where the center is the only one
    int32_t first_tile_x, first_tile_y, columns;
    TriangleRow* rows;                                        ///< [count] out, in the order of the mesh
    uint32_t* tiles;                                          ///< [count] out: beside `rows`
    uint32_t culled_back, culled_degenerate, culled_outside;  ///< out, added to
    int32_t hides_in_window;  ///< out: one culled by its side has pixel centers of the window in its box
};

/// Small opaque triangles against the depth that stands in one tile.
struct NearestJob {
    const TriangleRow* const* rows;  ///< [count]
    int32_t count;
    int32_t total;  ///< rows that follow each other, those of later jobs too: they are fetched ahead
    int32_t
        position;  ///< of the first in the tile's list: written to `visible` where it is nearer than what stands there
    int32_t tile_x, tile_y;            ///< [px] corner of the tile
    int32_t sample_x, sample_y;        ///< [1/256 px] from the pixels' centers: where they are looked at
    int32_t left, top, right, bottom;  ///< [px] of the tile that count, inclusive
    float farthest;                    ///< nothing in the tile is farther
    float* depth;                      ///< [tile_size * tile_size]
    int32_t* visible;
};

/// One opaque triangle in one tile, against the depth that stands there. Edges as in Coverage (coverage.h), in 32 bits.
struct CoverJob {
    int32_t left, top, right, bottom;  ///< px in the tile, inclusive
    int32_t edge[3], step_x[3], step_y[3];
    int32_t plane_x, plane_y;  ///< px in the tile: where depth is depth_0
    float depth_0, depth_x, depth_y, depth_low, depth_high;
    int32_t position;  ///< written to `visible` where the triangle is nearer than what stands there
    float* depth;      ///< [tile_size * tile_size]
    int32_t* visible;
};

struct RecordJob;
struct OcclusionJob;  // occlusion_types.h

/// The functions that exist once per instruction set.
struct GeometryKernels {
    void (*transform)(const VertexJob* job);
    int32_t (*set_up)(SetUpJob* job);  ///< returns how many passed
    /// Depth -1, visible -1. [tile_size * tile_size] both
    void (*clear_tile)(float* depth, int32_t* visible);
    /// `value` where nothing is visible. Of the tile's first pixel; `stride` pixels from row to row.
    void (*fill_empty)(const int32_t* visible, uint32_t value, uint32_t* out, int64_t stride);
    /// The least depth in a part of a tile, px inclusive; -1 where a pixel is still empty.
    float (*farthest)(const float* depth, int32_t left, int32_t top, int32_t right, int32_t bottom);
    int32_t (*nearest)(const NearestJob* job);  ///< returns how many pixels were written
    int32_t (*cover)(const CoverJob* job);      ///< the same
    /// Lists the pixels [tile_size * tile_size] whose `visible` is in begin..end-1 and what they show, block by block
    /// (block_side), row by row in each, those of a wholly filled vector first; returns their number. Writes up to
    /// batch_padding past it.
    int32_t (*collect)(const int32_t* visible, int32_t begin, int32_t end, int32_t* pixel, int32_t* list_position);
    /// Numbers what `count` pixels show, each triangle once, in the order of their first pixels: position in the tile's
    /// list -> `record`, which is -1 before, pixel -> `triangle`, number -> `wanted`. Returns how many there are. Reads
    /// `list_position` and writes `triangle` up to batch_padding past count: dead lanes must repeat what a pixel shows.
    int32_t (*number)(const int32_t* list_position, int32_t count, int32_t* record, int32_t* triangle, int32_t* wanted);
    /// Returns whether there are pieces (TriangleRow::is_piece): their records mean nothing.
    int32_t (*record)(const RecordJob* job);
    void (*occlusion)(const OcclusionJob* job);         ///< ambient occlusion of pixels, one by one
    void (*smooth_occlusion)(const OcclusionJob* job);  ///< the mean of neighbors on the same surface
};

namespace scalar {
const GeometryKernels* geometry_kernels();
}
namespace sse2 {
const GeometryKernels* geometry_kernels();
}
namespace avx2 {
const GeometryKernels* geometry_kernels();
}
namespace avx512 {
const GeometryKernels* geometry_kernels();
}

}  // namespace rakelight::raster
