// SPDX-License-Identifier: Apache-2.0
// Finished tiles, and who takes them: a sink for each kind of picture, among them a frame in memory.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/math/vector.h>

namespace rakelight {

/// A rectangle of pixels; row 0 on top.
struct Window {
    int x = 0, y = 0, width = 0, height = 0;  ///< [px]; all 0: the whole picture
    bool operator==(const Window&) const = default;
};

/// A finished rectangle: arrays are [width * height], row by row; channels that were not requested are empty.
struct Tile {
    Window area{};
    std::span<const vec4> color{};  ///< linear RGB, not clamped; alpha is coverage
    std::span<const float> depth{};
    std::span<const vec3> normal{};
    std::span<const std::uint32_t> object{}, material{};
    std::span<const std::uint16_t> samples{};  ///< samples in each pixel; empty: one in each
    std::span<const std::uint32_t> mesh{}, triangle{}, overdraw{};
    std::span<const vec3> face_normal{}, position{}, barycentric{};
    std::span<const vec4> tangent{};
    std::span<const vec2> uv{}, uv1{};
    std::span<const vec3> base_color{}, ambient{}, diffuse{}, specular{}, emission{};
    std::span<const vec3> albedo{}, direct{}, indirect{};
    std::span<const float> variance{}, ambient_occlusion{};
};

/// Rows of display values in the sink's memory: R in the low byte, straight alpha.
struct DisplayRows {
    std::uint32_t* first = nullptr;  ///< null: none
    std::size_t stride = 0;          ///< [px] from row to row
};

/// Receives finished tiles. The order of tiles does not affect the result. Progressive engines deliver several passes.
/// What a sink does not override is as for one that stores the whole picture in linear colors.
class RL_API Sink {
public:
    virtual ~Sink() = default;
    /// Called before the first tile: size of the whole picture, the window, the channels.
    virtual void begin(int width, int height, Window window, std::uint32_t channels) = 0;
    /// Called from any thread, concurrently, but never for overlapping tiles of one pass.
    virtual void tile(const Tile& tile) = 0;
    /// Called after all tiles of a pass, from the thread that called render().
    virtual void end_pass(int pass) = 0;

    /// Number of rows that this sink can store: at least 64. 0: the whole window. Called after begin(). Engines deliver
    /// strips of at most this many rows, from the top, in one pass. After all tiles of a strip they call rows_done().
    virtual int rows_at_once() const { return 0; }
    /// Called after all tiles of a strip, from the thread that called render(). The `rows` rows from row `first` on are
    /// complete.
    virtual void rows_done(int first, int rows) { (void)first, (void)rows; }

    /// Whether a cancelled picture should be delivered. Engines with several passes then deliver the finished passes.
    virtual bool wants_partial() const { return false; }

    /// Whether to deliver tiles as 8-bit display values, clamped and correctly rounded, instead of linear colors.
    /// Engines need not heed it.
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
    ///         in the memory of display_rows()
    virtual void display_tile(const Tile& tile, std::span<const std::uint32_t> srgb8) { (void)tile, (void)srgb8; }
};

/// One array per channel, [pixels] of a rectangle; channels that were not requested are empty.
struct ChannelArrays {
    std::vector<float> depth{};
    std::vector<vec3> normal{};
    std::vector<std::uint32_t> object{}, material{}, mesh{}, triangle{}, overdraw{};
    std::vector<vec3> face_normal{}, position{}, barycentric{};
    std::vector<vec4> tangent{};
    std::vector<vec2> uv{}, uv1{};
    std::vector<vec3> base_color{}, ambient{}, diffuse{}, specular{}, emission{};
    std::vector<vec3> albedo{}, direct{}, indirect{};
    std::vector<float> variance{}, ambient_occlusion{};
};

/// A sink that stores all data of a window. Pixel (x, y) of the picture is at (y - window.y) * window.width + x -
/// window.x.
class RL_API Frame final : public Sink, public ChannelArrays {
public:
    void begin(int width, int height, Window window, std::uint32_t channels) override;  ///< @throws Error: too large
    void tile(
        const Tile& tile) override;  ///< @throws Error usage: outside of the window, or an array of the wrong size
    void end_pass(int pass) override;

    int width = 0, height = 0;  ///< of the whole picture
    Window window;
    std::vector<vec4> color;  ///< [window.width * window.height] linear RGB and alpha, as in Tile
};

}  // namespace rakelight
