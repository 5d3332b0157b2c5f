// SPDX-License-Identifier: Apache-2.0
// Triangles: clipping -> screen -> culling -> tiles.
#include "engines/raster/geometry/front_end.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "base/format_text.h"
#include "engines/raster/geometry/set_up.h"
#include "math/flush_denormals.h"

namespace rakelight::raster {
namespace {

void add(RenderStats& sum, const TriangleCounts& part) {
    sum.culled_back += part.culled_back;
    sum.culled_degenerate += part.culled_degenerate;
    sum.culled_outside += part.culled_outside;
    sum.clipped += part.clipped;
    sum.drawn += part.drawn;
}

std::vector<ChunkRange> cut_into_chunks(const FrontEnd& front) {
    std::vector<ChunkRange> ranges;
    for (std::size_t d = 0; d < front.list.draws.size(); ++d) {
        if (front.clip[d].empty()) continue;
        const std::size_t triangles = front.list.scene.meshes[front.list.draws[d].mesh].indices.size() / 3;
        for (std::size_t t = 0; t < triangles; t += triangles_per_chunk)
            ranges.push_back({d, t, std::min(triangles, t + triangles_per_chunk)});
    }
    return ranges;
}

/// Where the runs of a chunk go: each chunk's after those of the chunks before.
using RunPlaces = std::vector<std::vector<std::uint32_t>>;

/// The lists of the tiles without their items, whose places are returned.
RunPlaces list_tiles(Binned& binned, const std::vector<ChunkRange>& ranges, std::size_t tiles) {
    const std::vector<ChunkTriangles>& chunks = binned.memory->chunks;
    std::vector<std::uint64_t> count(tiles + 1, 0);
    std::vector<std::uint32_t> last(tiles, no_index);  // the draw of the tile's last run
    binned.run_offsets.assign(tiles + 1, 0);
    for (std::size_t c = 0; c < ranges.size(); ++c)
        for (const ChunkRun& run : chunks[c].runs) {
            count[run.tile + 1] += run.count;
            binned.run_offsets[run.tile + 1] += last[run.tile] != ranges[c].draw;
            last[run.tile] = std::uint32_t(ranges[c].draw);
        }
    for (std::size_t t = 0; t < tiles; ++t) {
        binned.run_offsets[t + 1] += binned.run_offsets[t];
        count[t + 1] += count[t];
    }
    if (count[tiles] > 0xFFFFFFFFull) throw Error(ErrorCode::failed, "too many triangles for one picture");
    binned.offsets.assign(count.begin(), count.end());
    binned.runs.resize(binned.run_offsets[tiles]);
    binned.items.resize(std::size_t(count[tiles]));
    std::vector<std::uint32_t> next(binned.run_offsets.begin(), binned.run_offsets.end() - 1);
    std::fill(last.begin(), last.end(), no_index);
    RunPlaces places(ranges.size());
    for (std::size_t c = 0; c < ranges.size(); ++c)
        for (const ChunkRun& run : chunks[c].runs) {
            const auto place = std::uint32_t(count[run.tile]);
            count[run.tile] += run.count;
            places[c].push_back(place);
            if (std::exchange(last[run.tile], std::uint32_t(ranges[c].draw)) != ranges[c].draw)
                binned.runs[next[run.tile]++] = {place, 0, std::uint32_t(ranges[c].draw), false};
            TileRun& of_tile = binned.runs[next[run.tile] - 1];
            of_tile.count += run.count;
            of_tile.has_large |= run.has_large;
        }
    return places;
}

std::unique_ptr<SetUpScratch> take_scratch(SetUpMemory& memory, std::size_t tiles) {
    const std::lock_guard lock(memory.mutex);
    std::unique_ptr<SetUpScratch> scratch;
    if (memory.free.empty()) {
        scratch = std::make_unique<SetUpScratch>();
    } else {
        scratch = std::move(memory.free.back());
        memory.free.pop_back();
    }
    scratch->count.resize(tiles, 0);
    return scratch;
}

void give_back(SetUpMemory& memory, std::unique_ptr<SetUpScratch> scratch) {
    const std::lock_guard lock(memory.mutex);
    memory.free.push_back(std::move(scratch));
}

void renew(SetUpMemory& memory, std::size_t chunks) {
    memory.blocks.take_all_back();
    for (const std::unique_ptr<SetUpScratch>& scratch : memory.free) scratch->next_row = scratch->end_of_rows = nullptr;
    memory.chunks.resize(std::max(memory.chunks.size(), chunks));
}

}  // namespace

void PictureMemory::add(std::uint64_t bytes) {
    if (bytes <= limit_ && charge_.bytes() <= limit_ - bytes) return charge_.grow(bytes, "the picture");
    throw Error(
        ErrorCode::bad_file,
        format_text("the picture's triangles, lines and points need more than {} bytes, half of the limit", limit_), {},
        "raise 'max-memory', or render a part of the picture with 'window'")
        .naming({"max-memory", "window"});
}

TileGrid::TileGrid(int width, int height, Window w) : window(w.width == 0 ? Window{0, 0, width, height} : w) {
    first_x = window.x / tile_size;
    first_y = window.y / tile_size;
    columns = (window.x + window.width - 1) / tile_size - first_x + 1;
    rows = (window.y + window.height - 1) / tile_size - first_y + 1;
}

Window TileGrid::pixels(std::size_t i) const {
    const int left = std::max(origin_x(i), window.x), top = std::max(origin_y(i), window.y);
    const int right = std::min(origin_x(i) + tile_size, window.x + window.width);
    const int bottom = std::min(origin_y(i) + tile_size, window.y + window.height);
    return {left, top, right - left, bottom - top};
}

bool edge_planes(const ClipVertex (&v)[3], const PictureCamera& view, double x0, double y0, EdgePlanes& out) {
    // Rows of the adjugate of the matrix whose columns are the vertices in homogeneous pixel coordinates.
    dvec3 h[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const double x = v[i].x, y = v[i].y, w = v[i].w;
        h[i] = {(x * 0.5 + w * 0.5) * view.width - x0 * w, (w * 0.5 - y * 0.5) * view.height - y0 * w, w};
    }
    const dvec3 rows[3] = {cross(h[1], h[2]), cross(h[2], h[0]), cross(h[0], h[1])};
    const double determinant = dot(h[0], rows[0]);
    if (!(std::fabs(determinant) > 0) || !std::isfinite(1 / determinant)) return false;
    const double inverse = 1 / determinant;
    for (std::size_t i = 0; i < 3; ++i) {
        out.ex[i] = rows[i].x * inverse;
        out.ey[i] = rows[i].y * inverse;
        out.e0[i] = rows[i].z * inverse;
    }
    return true;
}

Binned set_up_and_bin(FrontEnd& front, const TileGrid& grid, Binned&& used, Context& context) {
    const std::vector<ChunkRange> ranges = cut_into_chunks(front);
    Binned binned = std::move(used);
    if (!binned.memory) binned.memory = std::make_shared<SetUpMemory>();
    SetUpMemory& memory = *binned.memory;
    front.memory.add(ranges.size() * sizeof(ChunkTriangles));
    renew(memory, ranges.size());
    context.parallel_for(ranges.size(), [&](std::size_t c) {
        const FlushDenormals guard;
        auto scratch = take_scratch(memory, grid.count());
        set_up_chunk(front, grid, ranges[c], memory.blocks, *scratch, memory.chunks[c]);
        give_back(memory, std::move(scratch));
    });
    context.throw_if_cancelled();
    front.culled_by_side.assign(front.list.draws.size(), 0);
    for (std::size_t c = 0; c < ranges.size(); ++c) {
        add(front.stats, memory.chunks[c].counts);
        front.culled_by_side[ranges[c].draw] |= memory.chunks[c].hides_in_window;
    }
    const RunPlaces places = list_tiles(binned, ranges, grid.count());
    context.parallel_for(ranges.size(), [&](std::size_t c) {
        const ChunkTriangles& chunk = memory.chunks[c];
        for (std::size_t r = 0; r < chunk.runs.size(); ++r)
            std::copy_n(chunk.sorted.begin() + chunk.runs[r].first, chunk.runs[r].count,
                        binned.items.begin() + places[c][r]);
    });
    return binned;
}

}  // namespace rakelight::raster
