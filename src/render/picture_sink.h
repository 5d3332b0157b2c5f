// SPDX-License-Identifier: Apache-2.0
// The sink of a picture that goes to a file: tiles become display values at once, so a plain picture needs no float
// frame.
#pragma once
#include <cstddef>
#include <vector>

#include <rakelight/engine.h>

#include "render/rows.h"

namespace rakelight {

/// Data channels as image files hold them: rows of 32-bit floats.
struct ChannelPlane {
    std::uint32_t channel = 0;  ///< one Channel bit
    int components = 1;
    std::vector<float> values;  ///< [window pixels * components]
};

/// How a channel is stored in an image file: depth [m] with +infinity where nothing is, normals as they are, numbers of
/// objects and materials as floats (exact up to 2^24) with -1 where nothing is.
const char* name_of_channel(std::uint32_t channel);
int components_of_channel(std::uint32_t channel);

class PictureSink final : public Sink {
public:
    explicit PictureSink(PixelFormat format) : format_(format) {}

    void begin(int width, int height, Window window, std::uint32_t channels) override;
    bool takes_srgb8() const override { return format_.component == Component::u8; }
    void tile(const Tile& tile) override;
    void end_pass(int) override {}

    /// Rows of the window, the first is 0.
    const std::byte* color_row(int y) const {
        return color_.data() + std::size_t(y) * std::size_t(window_.width) * format_.bytes();
    }
    const float* channel_row(std::size_t plane, int y) const;
    const std::vector<ChannelPlane>& planes() const { return planes_; }

private:
    void store(ChannelPlane& plane, const Tile& tile, std::size_t from, std::size_t to, std::size_t count) const;

    PixelFormat format_;
    Window window_;
    std::vector<std::byte> color_;
    std::vector<ChannelPlane> planes_;
};

}  // namespace rakelight
