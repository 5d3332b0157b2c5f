// SPDX-License-Identifier: Apache-2.0
// A sink for pictures that go to a file: it need not hold the whole picture, and takes display values. Engines that know
// it serve it so; to all others it is a plain sink, and has to hold the whole window.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include <rakelight/engine.h>
#include <rakelight/export.h>

namespace rakelight {

/// Rows of display values in a sink's own memory: R in the low byte, straight alpha.
struct DisplayRows {
    std::uint32_t* first = nullptr;  ///< null: there are none
    std::size_t stride = 0;          ///< [px] from row to row
};

/// A sink that takes the picture in strips of rows.
class RL_API StripSink : public Sink {
public:
    /// How many rows this sink holds at once: 0 all of the window, else 64 or more. Asked after begin(). Engines
    /// deliver the window in strips of at most so many rows, from the top: all tiles of a strip, rows_done(), then the
    /// next strip.
    virtual int rows_at_once() const { return 0; }
    /// After all tiles of a strip, from the thread that called render(): `rows` rows of the picture from row `first`
    /// are there.
    virtual void rows_done(int first, int rows) { (void)first, (void)rows; }

    /// Whether a cancelled picture is wanted as far as it is. Engines that go over the picture several times finish it then.
    virtual bool takes_partial() const { return false; }

    /// Whether tiles should come as 8-bit display values, clamped and correctly rounded, in place of linear colors.
    virtual bool takes_srgb8() const { return false; }
    /// Where display values of a rectangle may be made (written, and read again), by sinks that take them. From any
    /// thread, for rectangles as in tile().
    virtual DisplayRows display_rows(const Window& area) {
        (void)area;
        return {};
    }
    /// In place of tile(), to sinks that take display values. From any thread, as tile().
    /// @param tile   without colors
    /// @param srgb8  [width * height] R in the low byte, straight alpha; empty: they were made in display_rows()
    virtual void display_tile(const Tile& tile, std::span<const std::uint32_t> srgb8) { (void)tile, (void)srgb8; }
};

}  // namespace rakelight
