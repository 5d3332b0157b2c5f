// SPDX-License-Identifier: Apache-2.0
// Warnings about a picture that shows the model black, or most of it white.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rakelight/render/picture.h>

namespace rakelight {

/// Pixels of 8-bit pictures whose red, green and blue are all 0, or all 255. Counting is thread-safe.
class ExtremePixels {
public:
    /// @param srgb8  R in the low byte
    void add(std::span<const std::uint32_t> srgb8);
    /// @param row  [count * channels], 3 or 4
    void add_row(const std::byte* row, std::size_t count, int channels);
    std::uint64_t black() const { return black_; }
    std::uint64_t white() const { return white_; }

private:
    void add(std::uint64_t black, std::uint64_t white);
    std::atomic<std::uint64_t> black_{0}, white_{0};
};

/// Warns if every pixel that the model covers is black, with the likely reason, and if more than two thirds of them
/// are white although they are lit. No warning is possible for pictures with lines or points, with blended surfaces,
/// or in front of a sky: those pixels are counted too.
/// @param scene  as the engine drew it
void remark_extremes(const Scene& scene, const PictureRequest& request, const PictureResult& result, Report& report);

}  // namespace rakelight
