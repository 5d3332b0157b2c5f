// SPDX-License-Identifier: Apache-2.0
// A sink for picture files that accepts strips and display values, so that it need not store the whole picture. Some
// engines support such sinks and deliver strips. For other engines it is a plain sink that must store the whole window.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include <rakelight/engine.h>
#include <rakelight/export.h>

namespace rakelight {

/// Rows of display values in the sink's memory: R in the low byte, straight alpha.
struct DisplayRows {
    std::uint32_t* first = nullptr;  ///< null: none
    std::size_t stride = 0;          ///< [px] from row to row
};

/// A sink that receives the picture in strips of rows.
class RL_API StripSink : public Sink {
public:
    /// Number of rows that this sink can store: at least 64. 0: the whole window. Called after begin(). Engines deliver
    /// strips of at most this many rows, from the top. After all tiles of a strip they call rows_done().
    virtual int rows_at_once() const { return 0; }
    /// Called after all tiles of a strip, from the thread that called render(). The `rows` rows from row `first` on are
    /// complete.
    virtual void rows_done(int first, int rows) { (void)first, (void)rows; }

    /// Whether a cancelled picture should be delivered. Engines with several passes then deliver the finished passes.
    virtual bool wants_partial() const { return false; }

    /// Whether to deliver tiles as 8-bit display values, clamped and correctly rounded, instead of linear colors.
    virtual bool wants_srgb8() const { return false; }
    /// Memory of the sink in which the engine may compute the display values of a rectangle. The engine may read and
    /// write this memory. Called from any thread, for rectangles as in tile().
    virtual DisplayRows display_rows(const Window& area) {
        (void)area;
        return {};
    }
    /// Called instead of tile() if wants_srgb8() is true. From any thread, as tile().
    /// @param tile   without colors
    /// @param srgb8 [width * height] display values, R in the low byte, straight alpha. Empty: the display values are
    ///         in
    ///        the memory of display_rows()
    virtual void display_tile(const Tile& tile, std::span<const std::uint32_t> srgb8) { (void)tile, (void)srgb8; }
};

}  // namespace rakelight
