// SPDX-License-Identifier: Apache-2.0
// Marks over the colors of a tile without blended surfaces.
#include "engines/raster/blend.h"
#include "engines/raster/marks/tile_marks.h"

namespace rakelight::raster {

bool has_marks(const TileJob& job, std::size_t tile) {
    return job.marks && !job.marks->is_empty() && job.marks->offsets[tile] < job.marks->offsets[tile + 1];
}

void draw_marks(const TileJob& job, std::size_t tile, TileScratch& s) {
    TileMarks marks(job, tile, s);
    std::vector<std::uint32_t> touched;  // pixels where something waits
    s.pending.resize(tile_pixels);
    const auto lay_on = [&](std::uint32_t pixel) {
        return [&s, pixel](vec4 color) {
            lay_over(color, s.color[pixel]);
            ++s.marked;
        };
    };
    marks.for_each_fragment([&](const MarkFragment& f) {
        PendingMark& pending = s.pending[f.pixel];
        if (pending.coverage == 0) touched.push_back(f.pixel);
        pending.add(f, lay_on(f.pixel));
        return pending.coverage >= 1;
    });
    s.mark_tests += marks.tests();
    for (const std::uint32_t p : touched) s.pending[p].finish(lay_on(p));
    marks.put_channels();
}

}  // namespace rakelight::raster
