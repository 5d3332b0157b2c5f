// SPDX-License-Identifier: Apache-2.0
// Blocks of a tile in which a point is hidden by a nearer one that covers the whole block: of many large points in one
// place, few are drawn in each block.
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "engines/raster/marks/point_paraboloid.h"

namespace rakelight::raster {

class PointBlocks {
public:
    static constexpr int side = 8, across = tile_size / side, count = across * across;  ///< [px], blocks
    using Mask = std::uint64_t;                                                         ///< of blocks, row by row
    static_assert(count == 64);

    /// @param half  [px] the radius of points
    PointBlocks(const PointParaboloid& paraboloid, double half, int tile_x, int tile_y)
        : paraboloid_(paraboloid), half_(half), ox_(tile_x), oy_(tile_y) {}

    /// [px] the picture's pixels in a block.
    Window window(int block) const { return {ox_ + block % across * side, oy_ + block / across * side, side, side}; }
    /// The blocks that a point may reach where none of the points hides it that are known to cover them.
    Mask shown(const Mark& m, double reach) const;
    /// Makes a point known that is opaque and covers all of a block that is drawn to.
    void add(int block, const Mark& m) { add_to({block % across, block / across, 1}, m); }
    /// Makes an opaque point known, in a tile without surfaces that could hide it.
    void add(const Mark& m, const MarkShape& shape) { add_below({0, 0, across}, m, shape); }

private:
    /// Of blocks, of 1, 2, 4 or 8 along a side.
    struct Square {
        int column, row, side;
        int index() const {
            return (row / side) * (across / side) + column / side +
                   (side == 1   ? 0
                    : side == 2 ? 64
                    : side == 4 ? 80
                                : 84);
        }
        std::array<Square, 4> quarters() const {
            const int half = side / 2;
            return {{{column, row, half},
                     {column + half, row, half},
                     {column, row + half, half},
                     {column + half, row + half, half}}};
        }
    };
    static constexpr std::size_t squares = 64 + 16 + 4 + 1;
    dvec2 center(const Square& s) const {
        return {ox_ + side * (s.column + 0.5 * s.side), oy_ + side * (s.row + 0.5 * s.side)};
    }
    void show(const Square& square, const Mark& m, double reach, Mask& out) const;
    void add_to(const Square& square, const Mark& m);
    void add_below(const Square& square, const Mark& m, const MarkShape& shape);
    /// Whether one point is nowhere nearer than the other one, within a distance of a place, by more than rounding.
    bool hides(const Mark& nearer, const Mark& m, dvec2 center, double distance) const;

    const PointParaboloid& paraboloid_;
    double half_;
    int ox_, oy_;
    std::array<std::optional<Mark>, squares> nearest_{};  ///< [Square::index()]
};

}  // namespace rakelight::raster
