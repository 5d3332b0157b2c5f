// SPDX-License-Identifier: Apache-2.0
// Triangles: clipping -> screen -> culling -> tiles.
#include "engines/raster/front_end.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "engines/raster/set_up.h"
#include "math/flush_denormals.h"

namespace rakelight::raster {
namespace {

/// Working memory of chunks, handed from one to the next.
class ScratchPool {
public:
    explicit ScratchPool(std::size_t tiles) : tiles_(tiles) {}
    std::unique_ptr<SetUpScratch> take() {
        const std::lock_guard lock(mutex_);
        if (free_.empty()) return std::make_unique<SetUpScratch>(tiles_);
        auto scratch = std::move(free_.back());
        free_.pop_back();
        return scratch;
    }
    void give_back(std::unique_ptr<SetUpScratch> scratch) {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(scratch));
    }

private:
    std::size_t tiles_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<SetUpScratch>> free_;
};

void add_stats(RenderStats& sum, const RenderStats& part) {
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

/// The lists of the tiles: the chunks' runs in the order of the chunks.
void list_tiles(Binned& binned, const std::vector<ChunkRange>& ranges, const std::vector<std::vector<ChunkRun>>& runs,
                std::size_t tiles) {
    binned.offsets.assign(tiles + 1, 0);
    binned.run_offsets.assign(tiles + 1, 0);
    std::uint64_t total = 0;
    for (const std::vector<ChunkRun>& of_chunk : runs)
        for (const ChunkRun& run : of_chunk) {
            ++binned.run_offsets[run.tile + 1];
            binned.offsets[run.tile + 1] += run.count;
            total += run.count;
        }
    if (total > 0xFFFFFFFFull) throw Error(ErrorCode::failed, "too many triangles for one picture");
    for (std::size_t t = 0; t < tiles; ++t) {
        binned.run_offsets[t + 1] += binned.run_offsets[t];
        binned.offsets[t + 1] += binned.offsets[t];
    }
    binned.runs.resize(binned.run_offsets[tiles]);
    binned.items.resize(std::size_t(total));
    std::vector<std::uint32_t> next(binned.run_offsets.begin(), binned.run_offsets.end() - 1);
    for (std::size_t c = 0; c < runs.size(); ++c)
        for (const ChunkRun& run : runs[c])
            binned.runs[next[run.tile]++] = {binned.chunks[c].rows.data() + run.first, run.count,
                                             std::uint32_t(ranges[c].draw), run.has_large};
}

void list_items(Binned& binned, std::size_t tile) {
    std::uint32_t next = binned.offsets[tile];
    for (std::uint32_t r = binned.run_offsets[tile]; r < binned.run_offsets[tile + 1]; ++r)
        for (std::uint32_t i = 0; i < binned.runs[r].count; ++i) binned.items[next++] = binned.runs[r].first + i;
}

}  // namespace

void PictureMemory::add(std::uint64_t bytes) {
    if ((used_ += bytes) <= limit_) return;
    throw Error(ErrorCode::bad_file, "the picture's triangles need more than " + std::to_string(limit_) + " bytes", {},
                "raise the limit with --max-memory, or render a part with --window");
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

bool edge_planes(const ClipVertex (&v)[3], const View& view, double x0, double y0, EdgePlanes& out) {
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
    binned.chunks.resize(ranges.size());
    std::vector<std::vector<ChunkRun>> runs(ranges.size());
    std::vector<RenderStats> stats(ranges.size());
    ScratchPool pool(grid.count());
    context.parallel_for(ranges.size(), [&](std::size_t c) {
        const FlushDenormals guard;
        auto scratch = pool.take();
        set_up_chunk(front, grid, ranges[c], *scratch, binned.chunks[c], runs[c], stats[c]);
        pool.give_back(std::move(scratch));
    });
    context.throw_if_cancelled();
    for (const RenderStats& part : stats) add_stats(front.stats, part);
    list_tiles(binned, ranges, runs, grid.count());
    context.parallel_for(grid.count(), [&](std::size_t tile) { list_items(binned, tile); });
    return binned;
}

}  // namespace rakelight::raster
