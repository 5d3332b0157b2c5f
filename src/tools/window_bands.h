// SPDX-License-Identifier: Apache-2.0
// Which windows provide which columns of a picture's rows: rows are grouped in bands that intersect the same windows.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include <rakelight/engines/engine.h>

namespace rakelight {

/// What a window provides to each row of a band. [px] columns of the picture
struct BandPiece {
    std::size_t window = 0;
    int begin = 0, own = 0, end = 0;  ///< begin..own is covered by pieces before it too, own..end is not
};

struct Band {
    int y = 0, end = 0;               ///< [px] rows
    std::vector<BandPiece> pieces{};  ///< from left to right; together all columns
};

/// The band that begins with row y. @param windows  within the picture, not empty
/// @throws Error bad_file: pixels that no window covers
Band band_at(std::span<const Window> windows, int y, int width, int height);

}  // namespace rakelight
