// SPDX-License-Identifier: Apache-2.0
#include "tools/window_bands.h"

#include <algorithm>
#include <string>

#include "base/format_text.h"

namespace rakelight {
namespace {

[[noreturn]] void refuse_gap(const Band& band, int begin, int end) {
    const auto range = [](int from, int to) { return format_text("{} to {}", from, to - 1); };
    const std::string window = format_text("{},{},{},{}", begin, band.y, end - begin, band.end - band.y);
    throw Error(ErrorCode::bad_file,
                "no window covers columns " + range(begin, end) + " of rows " + range(band.y, band.end), {},
                "render them with 'window' " + window)
        .naming({"window"});
}

}  // namespace

Band band_at(std::span<const Window> windows, int y, int width, int height) {
    Band band{y, height, {}};
    for (std::size_t i = 0; i < windows.size(); ++i) {
        const Window& w = windows[i];
        if (w.y > y) band.end = std::min(band.end, w.y);
        if (w.y > y || w.y + w.height <= y) continue;
        band.end = std::min(band.end, w.y + w.height);
        band.pieces.push_back({i, w.x, w.x, w.x + w.width});
    }
    std::ranges::stable_sort(band.pieces, {}, &BandPiece::begin);
    int covered = 0;
    for (BandPiece& piece : band.pieces) {
        if (piece.begin > covered) refuse_gap(band, covered, piece.begin);
        piece.own = std::min(std::max(piece.begin, covered), piece.end);
        covered = std::max(covered, piece.end);
    }
    if (covered < width) refuse_gap(band, covered, width);
    return band;
}

}  // namespace rakelight
