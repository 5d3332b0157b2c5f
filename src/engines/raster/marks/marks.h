// SPDX-License-Identifier: Apache-2.0
// Lines and points on the picture: edges and vertices of triangles where settings ask for them, and the lines and
// points that scenes hold. They are laid over the shaded surfaces, anti-aliased by coverage.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "engines/raster/geometry/front_end.h"

namespace rakelight::raster {

struct TileJob;
struct TileScratch;

/// A line between two places on the screen, or a point (both ends the same).
struct Mark {
    enum class Shape : std::uint8_t { line, square, disc };
    float x[2], y[2];        ///< [px] from the picture's corner; lines are cut where they leave it
    float key[2];            ///< reversed depth: affine along the line on the screen
    float part[2];           ///< where the ends lie between the line's own ends, 0..1: colors are interpolated by it
    std::uint32_t color[2];  ///< of the line's own ends, into Marks::colors
    Shape shape;

    /// Whether an end of a line is one of another line.
    bool joins(const Mark& other) const {
        for (const std::size_t i : {0, 1})
            for (const std::size_t k : {0, 1})
                if (x[i] == other.x[k] && y[i] == other.y[k] && key[i] == other.key[k]) return shape == other.shape;
        return false;
    }
};

struct Marks {
    std::vector<vec4> colors;  ///< linear RGB and opacity
    std::vector<std::vector<Mark>> chunks;
    std::vector<const Draw*> draws;      ///< [chunks] whose marks they are
    std::vector<std::uint32_t> offsets;  ///< [tiles + 1] into items; empty: there are no marks
    std::vector<std::uint64_t> items;    ///< chunk << 32 | index in the chunk, in the order of the scene
    bool is_of_one_color = true;
    bool is_empty() const { return offsets.empty(); }
    const Mark& at(std::uint64_t item) const { return chunks[item >> 32][item & 0xFFFFFFFFu]; }
};

/// Part of a mark that covers a part of a pixel.
struct MarkFragment {
    std::uint32_t pixel;         ///< of the tile
    std::uint32_t color_number;  ///< into Marks::colors; none: a mixture
    float key, coverage;         ///< reversed depth; more than 0, at most 1
    float reach;                 ///< [px] mark_reach() of the mark
    vec4 color;
    const Mark* mark;
    const Draw* draw;  ///< whose mark it is
};

/// A color that waits to be laid on a pixel, so that marks of one color which follow each other there are united: the
/// greater coverage counts, and corners are not darker. So are blended lines of several colors that share an end.
struct PendingMark {
    vec4 color;
    float coverage = 0;  ///< 0: nothing waits
    std::uint32_t color_number = no_index;
    const Mark* mark = nullptr;
    const Draw* draw = nullptr;

    /// @param lay  called with a color and its opacity
    template <class Lay>
    void add(const MarkFragment& f, const Lay& lay) {
        if (!goes_on(f)) finish(lay);
        if (f.coverage > coverage) color = f.color, coverage = f.coverage;
        color_number = f.color_number, mark = f.mark, draw = f.draw;
    }
    bool goes_on(const MarkFragment& f) const {
        if (f.color_number != color_number) return false;
        return f.color_number != no_index || (mark && f.draw == draw && f.color.w < 1 && mark->joins(*f.mark));
    }
    template <class Lay>
    void finish(const Lay& lay) {
        if (coverage > 0) lay(vec4{color.x, color.y, color.z, coverage * std::min(std::max(color.w, 0.0f), 1.0f)});
        *this = {};
    }
};

/// [px] half the diagonal of a pixel, rounded up: a border farther than this from its center does not cut it.
inline constexpr double half_diagonal = 0.70711;
/// [px] from the middle of a mark to the last pixel center that it may cover in part.
inline double mark_reach(float size) { return 0.5 * double(size) + half_diagonal; }

/// What settings and scene give, in the order: lines and points of the scene, edges, vertices. Triangles that culling
/// drops have neither. Same bits for any number of threads and any window.
/// @throws Error bad_file where they need more than PictureMemory allows; usage: sizes out of range; failed: cancelled
Marks make_marks(FrontEnd& front, const TileGrid& grid, Context& context);

/// Whether a tile has any.
bool has_marks(const TileJob& job, std::size_t tile);

/// Lays the marks of a tile without blended surfaces over its colors, into data channels too. A mark is hidden if it
/// is farther than the visible surface by more than the surface's change of depth over half the mark's width and half
/// a pixel. So marks on the surface are visible without gaps. Where colors differ, nearer marks lie over farther ones.
void draw_marks(const TileJob& job, std::size_t tile, TileScratch& scratch);

}  // namespace rakelight::raster
