// SPDX-License-Identifier: Apache-2.0
// The sink of a picture that is written to a file. Tiles are converted to display values at once, so a plain picture
// needs no float frame. Strips of rows are written as soon as they are complete.
#pragma once
#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <rakelight/engines/sink.h>

#include "render/remarks/too_dark_or_bright.h"
#include "render/rows.h"

namespace rakelight {

/// The rows of one data channel, as the engine gives them: values of four bytes.
struct ChannelPlane {
    std::uint32_t channel = 0;  ///< one Channel bit
    int components = 1;
    std::vector<std::uint32_t> words;  ///< [rows * window width * components] floats or integers, by info_of(channel)
};

class PictureSink final : public Sink {
public:
    /// Keeps the whole window, or after keep_strips() a strip of it.
    explicit PictureSink(PixelFormat format, const ToneCurve& tone = ToneCurve()) : format_(format), tone_(tone) {}

    /// Before begin(): calls `done` with the number of rows of each strip when they are there.
    /// @param linear  keep colors as linear floats too, for files of layers
    void keep_strips(bool linear, std::function<void(int)> done) {
        keeps_linear_ = linear, strip_done_ = std::move(done);
    }
    void begin(int width, int height, Window window, std::uint32_t channels) override;
    bool wants_srgb8() const override {
        return format_.component == Component::u8 && !keeps_linear_ && tone_.is_identity();
    }
    DisplayRows display_rows(const Window& area) override;
    void tile(const Tile& tile) override;
    void display_tile(const Tile& tile, std::span<const std::uint32_t> srgb8) override;
    bool wants_partial() const override { return gaps_.has_value(); }
    int rows_at_once() const override { return strip_done_ ? rows_ : 0; }
    void rows_done(int first, int rows) override;
    void end_pass(int) override {}

    /// Counts every 8-bit pixel that is black or white; null: no counting. Must outlive this.
    void count_in(ExtremePixels* pixels) { extremes_ = pixels; }

    /// Before begin(): the color of pixels that no tile covers; in the channels they have no surface.
    void expect_gaps(vec4 background) { gaps_ = background; }
    /// Fraction of the pixels that tiles have covered, 0..1.
    double done() const;
    /// Delivers the strips that are left, as they are, where strips are kept.
    void finish_partial();

    /// Before begin(): keep depths, for drawing over the picture. If the channel is hidden (requested only for this
    /// purpose), it is not delivered as a plane.
    void keep_depth(bool is_hidden) { keeps_depth_ = true, hides_depth_ = is_hidden; }
    /// The colors of the strip (or of the window), to be drawn on, with their depths if these are kept.
    PictureRows color_rows(int rows);
    /// The same of the linear colors, where they are kept.
    PictureRows linear_rows(int rows);

    /// Rows of the strip (or of the window), the first is 0.
    const std::byte* color_row(int y) const { return color_.data() + at_row(y) * format_.bytes(); }
    const float* linear_row(int y) const { return linear_.data() + at_row(y) * std::size_t(format_.channels); }
    const std::uint32_t* channel_row(std::size_t plane, int y) const {
        return planes_[plane].words.data() + at_row(y) * std::size_t(planes_[plane].components);
    }
    std::span<const ChannelPlane> planes() const { return std::span(planes_).first(planes_.size() - hides_depth_); }
    /// The colors of the whole window, row by row; the sink has none then.
    std::vector<std::byte> take_colors() { return std::move(color_); }

private:
    void empty_strip();
    bool is_kept(const Window& area) const;
    /// Where in the arrays of the strip a row of a tile begins.
    std::size_t place_of(const Tile& tile, int row) const;
    void keep_channels(const Tile& tile, int row);
    /// @param row  of 8-bit values in `color_`
    void count_extremes(const std::byte* row, std::size_t count);
    std::size_t at_row(int y) const { return std::size_t(y) * std::size_t(window_.width); }

    PixelFormat format_;
    ToneCurve tone_;
    bool keeps_linear_ = false, keeps_depth_ = false, hides_depth_ = false;
    std::optional<vec4> gaps_;
    std::atomic<std::uint64_t> brought_{0};  ///< pixels
    ExtremePixels* extremes_ = nullptr;
    std::function<void(int)> strip_done_;
    Window window_;
    int first_ = 0, rows_ = 0;  ///< the strip: its first row in the picture, how many are kept
    std::vector<std::byte> color_;
    std::vector<float> linear_;
    std::vector<ChannelPlane> planes_;
};

}  // namespace rakelight
