// SPDX-License-Identifier: Apache-2.0
// The geometry stages: object space -> clip space -> clipping -> screen -> back-face culling -> bins of tiles.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <rakelight/engines/engine.h>

#include "cpu_shading/draw_list.h"
#include "engines/raster/geometry/clip.h"
#include "engines/raster/kernels/kernel_types.h"

namespace rakelight::raster {

using cpu_shading::DrawList, shading::Draw, shading::DrawMaterial;

/// A triangle, or a piece of one that was clipped, on the screen.
struct ScreenTriangle : TriangleRow {
    std::int32_t x(std::size_t corner) const { return corner == 0 ? x0 : corner == 1 ? x1 : x2; }  ///< [1/256 px]
    std::int32_t y(std::size_t corner) const { return corner == 0 ? y0 : corner == 1 ? y1 : y2; }
    std::uint32_t bits(std::size_t corner) const { return corner == 0 ? bits0 : corner == 1 ? bits1 : bits2; }
    /// [1/2048 of 1/256 px] where the corner is without rounding to 1/256 px
    double true_x(std::size_t corner) const {
        return double(x(corner)) * (1 << fine_bits) + double(bits(corner) >> outcode_bits & fine_mask) - fine_middle;
    }
    double true_y(std::size_t corner) const {
        return double(y(corner)) * (1 << fine_bits) + double(bits(corner) >> (outcode_bits + fine_bits)) - fine_middle;
    }
    float nearest_key() const { return std::max({key0, key1, key2}); }
    float farthest_key() const { return std::min({key0, key1, key2}); }

private:
    static constexpr std::uint32_t fine_mask = (1u << fine_bits) - 1;
    static constexpr double fine_middle = 1 << (fine_bits - 1);
};
static_assert(sizeof(ScreenTriangle) == sizeof(TriangleRow));

/// A draw's vertices in clip space and on the screen, [vertices]; whole vectors may be loaded past their end.
using ClipVertices = std::span<ClipVertex>;
using ScreenVertices = std::span<ScreenVertex>;

/// The tiles of a picture that a window touches.
struct TileGrid {
    TileGrid(int width, int height, Window window);
    int first_x, first_y, columns, rows;  ///< in tiles
    Window window;
    std::size_t count() const { return std::size_t(columns) * std::size_t(rows); }
    std::size_t first_of_row(int row) const { return std::size_t(row) * std::size_t(columns); }
    /// The pixels of tile i that lie in the window.
    Window pixels(std::size_t i) const;
    int origin_x(std::size_t i) const { return (first_x + int(i % std::size_t(columns))) * tile_size; }
    int origin_y(std::size_t i) const { return (first_y + int(i / std::size_t(columns))) * tile_size; }
};

/// Triangles of one draw in one tile.
struct TileRun {
    std::uint32_t first, count;  ///< into Binned::items
    std::uint32_t draw;
    bool has_large;  ///< some is_large
};

struct SetUpMemory;

/// All triangles of a picture, set up and sorted into tiles, in the order of the scene whatever the number of threads.
struct Binned {
    std::vector<std::uint32_t> offsets;        ///< [tiles + 1] into items
    std::vector<const ScreenTriangle*> items;  ///< what is in each tile
    std::vector<std::uint32_t> run_offsets;    ///< [tiles + 1] into runs
    std::vector<TileRun> runs;                 ///< the same by draws
    std::shared_ptr<SetUpMemory> memory;       ///< where the triangles are
};

/// What the geometry of one picture takes. A file of a megabyte can place ten thousand instances of a mesh, or a
/// million triangles that each fill the picture. So this memory is charged and limited to half of the MemoryBudget.
/// Thread-safe.
class PictureMemory {
public:
    explicit PictureMemory(MemoryBudget& budget) : limit_(budget.limit() / 2), charge_(budget) {}
    /// @throws Error bad_file where the sum passes the limit, or the budget is spent
    void add(std::uint64_t bytes);
    void remove(std::uint64_t bytes) { charge_.shrink(bytes); }
    /// What was added, for who keeps the memory for the next picture.
    MemoryCharge take() { return std::move(charge_); }

private:
    std::uint64_t limit_;
    MemoryCharge charge_;
};

struct FrontEnd {
    const DrawList& list;
    const PictureCamera& view;
    const RenderSettings& settings;
    const GeometryKernels& kernels;
    std::vector<ClipVertex> clip_store;      ///< [vertices of all draws + row_padding]
    std::vector<ScreenVertex> screen_store;  ///< likewise
    std::vector<dmat4> to_eye;               ///< [draws] object -> world axes about the eye
    RenderStats stats;
    mutable PictureMemory memory;        ///< tiles count what they take, too
    std::vector<ClipVertices> clip;      ///< [draws] in `clip_store`; empty for draws wholly outside
    std::vector<ScreenVertices> screen;  ///< [draws] in `screen_store`
    std::vector<Shading> shading;        ///< [draws] never automatic; choose_shading()
    /// [draws] not 0: triangles whose box has pixel centers of the window were culled by the side they are seen from
    std::vector<std::uint8_t> culled_by_side;
    std::vector<MaterialJob> jobs;        ///< [draws] without lights; make_material_jobs()
    const ShadowView* shadows = nullptr;  ///< [maps]; null: none
    bool only_behind = false;             ///< shading::is_behind() says which draws there are
};

/// Whether attributes are linear on the screen.
inline bool is_affine(const FrontEnd& front) {
    return front.view.orthographic || front.settings.interpolation == AttributeInterpolation::screen;
}

/// Clip space -> screen: x = x / w * scale_x + offset_x, floored, about snap_origin; likewise y and the depth key.
struct ScreenMap {
    explicit ScreenMap(const PictureCamera& view);
    double scale_x, offset_x, scale_y, offset_y;  ///< [1/256 px]
    double key_scale, key_offset;
    bool orthographic;
};

/// A vertex on the screen, code 0; what is not in the guard band stops at its rim.
ScreenVertex snap_to_screen(const ScreenMap& map, const ClipVertex& v);

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
bool edge_planes(const ClipVertex (&v)[3], const PictureCamera& view, double x0, double y0, EdgePlanes& out);

}  // namespace rakelight::raster
