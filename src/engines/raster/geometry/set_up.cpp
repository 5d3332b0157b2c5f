// SPDX-License-Identifier: Apache-2.0
// Most triangles are done by the kernel (kernels/set_up_kernel.h); here is what it leaves: what is cut, large, or
// touches several tiles; and the sorting.
#include "engines/raster/geometry/set_up.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "shading/draw_choices.h"
#include "shading/sample_positions.h"

namespace rakelight::raster {
namespace {

constexpr int tile_fixed = tile_size << subpixel_bits;
constexpr std::uint64_t entry_bytes =
    2 * sizeof(decltype(Binned::items)::value_type);  // sorted by chunks, and by tiles

/// The pixels of which a sample may be inside, in the window.
struct Box {
    int left, right, top, bottom;
};

/// @param reach  as in SetUpJob
Box box_of(std::array<std::int32_t, 3> x, std::array<std::int32_t, 3> y, const Window& window, int reach) {
    const auto [x_low, x_high] = std::minmax({x[0], x[1], x[2]});
    const auto [y_low, y_high] = std::minmax({y[0], y[1], y[2]});
    Box box;
    box.left = std::max((x_low + 127 - reach) >> subpixel_bits, window.x);
    box.right = std::min((x_high - 128 + reach) >> subpixel_bits, window.x + window.width - 1);
    box.top = std::max((y_low + 127 - reach) >> subpixel_bits, window.y);
    box.bottom = std::min((y_high - 128 + reach) >> subpixel_bits, window.y + window.height - 1);
    return box;
}

Box box_of(const ScreenTriangle& s, const Window& window, int reach) {
    return box_of({s.x0, s.x1, s.x2}, {s.y0, s.y1, s.y2}, window, reach);
}

/// False when one edge has the whole tile on its outer side.
bool touches(const ScreenTriangle& s, int tx, int ty) {
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t n = (k + 1) % 3;
        const std::int64_t dx = s.x(n) - s.x(k), dy = s.y(n) - s.y(k);
        const std::int64_t px = std::int64_t(tx) * tile_fixed + (dy < 0 ? tile_fixed : 0);
        const std::int64_t py = std::int64_t(ty) * tile_fixed + (dx > 0 ? tile_fixed : 0);
        if (dx * (py - s.y(k)) - dy * (px - s.x(k)) < 0) return false;
    }
    return true;
}

class ChunkSetUp {
public:
    ChunkSetUp(FrontEnd& front, const TileGrid& grid, const ChunkRange& range, RowBlocks& blocks, SetUpScratch& scratch,
               TriangleCounts& counts)
        : front_(front),
          grid_(grid),
          range_(range),
          blocks_(blocks),
          s_(scratch),
          counts_(counts),
          draw_(front.list.draws[range.draw]),
          mesh_(front.list.scene.meshes[draw_.mesh]),
          culling_(shading::culling_of(front.list, draw_, front.settings)),
          volume_(front.view),
          map_(front.view),
          reach_(shading::sample_reach(front.settings.samples)) {}

    void run() {
        s_.entry_count = 0;
        s_.tiles.resize(triangles_per_chunk);
        ScreenTriangle* const rows = rows_for(triangles_per_chunk);
        const auto passed = std::size_t(run_kernel(rows));
        s_.next_row += passed;
        new_bytes_ = passed * sizeof(ScreenTriangle);
        for (std::size_t i = 0; i < passed;) {
            i = enter_those_of_one_tile(rows, i, passed);
            if (i == passed) break;
            if (s_.tiles[i] == to_be_cut)
                add(rows[i].triangle);
            else
                bin(rows + i, box_of(rows[i], grid_.window, reach_));
            ++i;
        }
        front_.memory.add(new_bytes_ + s_.entry_count * entry_bytes - told_bytes_);
    }

    bool has_large() const { return has_large_; }
    bool hides_in_window() const { return hides_in_window_; }

private:
    ScreenTriangle* rows_for(std::size_t count) {
        if (std::size_t(s_.end_of_rows - s_.next_row) < count) {
            s_.next_row = blocks_.take();
            s_.end_of_rows = s_.next_row + RowBlocks::block_rows;
        }
        return s_.next_row;
    }

    std::int32_t run_kernel(ScreenTriangle* rows) {
        SetUpJob job{};
        job.indices = mesh_.indices.data() + 3 * range_.first;
        job.count = std::int32_t(range_.end - range_.first);
        job.first = std::uint32_t(range_.first);
        job.draw = std::uint32_t(range_.draw);
        job.vertices = front_.screen[range_.draw].data();
        job.cull_back = culling_.back, job.cull_front = culling_.front,
        job.front_is_negative = culling_.front_is_negative;
        const Window& w = grid_.window;
        job.left = w.x, job.top = w.y, job.right = w.x + w.width - 1, job.bottom = w.y + w.height - 1;
        job.reach = reach_;
        job.first_tile_x = grid_.first_x, job.first_tile_y = grid_.first_y, job.columns = grid_.columns;
        job.rows = rows;
        job.tiles = s_.tiles.data();
        const std::int32_t passed = front_.kernels.set_up(&job);
        counts_.culled_back += job.culled_back;
        counts_.culled_degenerate += job.culled_degenerate;
        counts_.culled_outside += job.culled_outside;
        hides_in_window_ = job.hides_in_window != 0;
        return passed;
    }

    /// A triangle that passes a cutting plane, or a large one.
    void add(std::uint32_t t) {
        const std::uint32_t* const index = mesh_.indices.data() + 3 * std::size_t(t);
        ScreenVertex corner[3];
        unsigned planes = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            corner[k] = front_.screen[range_.draw][index[k]];
            planes |= corner[k].bits & cutting_planes;
        }
        if (planes == 0) return add(corner, t, false);
        const ClipVertices& clip = front_.clip[range_.draw];
        const ClipVertex v[3] = {clip[index[0]], clip[index[1]], clip[index[2]]};
        ClipVertex polygon[max_clipped_vertices];
        const std::size_t count = clip_triangle(v, planes, volume_, polygon);
        ++counts_.clipped;
        for (std::size_t k = 2; k < count; ++k) {
            const ScreenVertex piece[3] = {snap_to_screen(map_, polygon[0]), snap_to_screen(map_, polygon[k - 1]),
                                           snap_to_screen(map_, polygon[k])};
            add(piece, t, true);
        }
    }

    /// What kernels/set_up_kernel.h does, for any size.
    void add(const ScreenVertex (&corner)[3], std::uint32_t t, bool is_piece) {
        const std::int64_t area = std::int64_t(corner[1].x - corner[0].x) * (corner[2].y - corner[0].y) -
                                  std::int64_t(corner[2].x - corner[0].x) * (corner[1].y - corner[0].y);
        const bool is_back = (area < 0) != culling_.front_is_negative;
        if (area == 0) {
            ++counts_.culled_degenerate;
            return;
        }
        if (is_back ? culling_.back : culling_.front) {
            ++counts_.culled_back;
            const Box hidden = box_of({corner[0].x, corner[1].x, corner[2].x}, {corner[0].y, corner[1].y, corner[2].y},
                                      grid_.window, reach_);
            hides_in_window_ |= hidden.left <= hidden.right && hidden.top <= hidden.bottom;
            return;
        }
        const ScreenVertex &a = corner[0], &b = corner[area < 0 ? 2 : 1], &c = corner[area < 0 ? 1 : 2];
        ScreenTriangle s;
        s.x0 = a.x, s.x1 = b.x, s.x2 = c.x;
        s.y0 = a.y, s.y1 = b.y, s.y2 = c.y;
        s.key0 = a.key, s.key1 = b.key, s.key2 = c.key;
        s.bits0 = a.bits, s.bits1 = b.bits, s.bits2 = c.bits;
        s.draw = std::uint32_t(range_.draw), s.triangle = t;
        s.is_back = is_back, s.is_piece = is_piece, s.is_swapped = area < 0;
        const auto [x_low, x_high] = std::minmax({s.x0, s.x1, s.x2});
        const auto [y_low, y_high] = std::minmax({s.y0, s.y1, s.y2});
        s.is_large = x_high - x_low >= small_extent || y_high - y_low >= small_extent;
        const Box box = box_of(s, grid_.window, reach_);
        if (box.left > box.right || box.top > box.bottom) {
            ++counts_.culled_outside;
            return;
        }
        has_large_ |= s.is_large;
        ScreenTriangle* const row = rows_for(1);
        *row = s;
        ++s_.next_row;
        new_bytes_ += sizeof(ScreenTriangle);
        bin(row, box);
    }

    void bin(const ScreenTriangle* row, const Box& box) {
        const std::size_t before = s_.entry_count;
        const int first_x = box.left / tile_size, last_x = box.right / tile_size;
        const int first_y = box.top / tile_size, last_y = box.bottom / tile_size;
        const bool is_in_one = first_x == last_x && first_y == last_y;
        for (int ty = first_y; ty <= last_y; ++ty)
            for (int tx = first_x; tx <= last_x; ++tx)
                if (is_in_one || touches(*row, tx, ty))
                    enter(std::uint32_t((ty - grid_.first_y) * grid_.columns + tx - grid_.first_x), row);
        ++(s_.entry_count > before ? counts_.drawn : counts_.culled_outside);
        const std::uint64_t bytes = new_bytes_ + s_.entry_count * entry_bytes;
        if (bytes - told_bytes_ > 1 << 20) front_.memory.add(bytes - std::exchange(told_bytes_, bytes));
    }

    /// Rows from i on, up to the first that needs a look. Returns the number of that one.
    std::size_t enter_those_of_one_tile(const ScreenTriangle* rows, std::size_t i, std::size_t passed) {
        make_room(passed - i);
        const std::size_t begin = i;
        const std::uint32_t* const tiles = s_.tiles.data();
        std::uint32_t* const count = s_.count.data();
        SetUpScratch::Entry* next = s_.entries.data() + s_.entry_count;
        for (; i < passed && tiles[i] < to_be_cut; ++i) {
            *next++ = {tiles[i], rows + i};
            if (count[tiles[i]]++ == 0) s_.touched.push_back(tiles[i]);
        }
        s_.entry_count += i - begin;
        counts_.drawn += std::uint32_t(i - begin);
        return i;
    }

    void make_room(std::size_t more) {
        if (s_.entries.size() < s_.entry_count + more) s_.entries.resize(2 * s_.entries.size() + more);
    }

    void enter(std::uint32_t tile, const ScreenTriangle* row) {
        make_room(1);
        s_.entries[s_.entry_count++] = {tile, row};
        if (s_.count[tile]++ == 0) s_.touched.push_back(tile);
    }

    FrontEnd& front_;
    const TileGrid& grid_;
    const ChunkRange& range_;
    RowBlocks& blocks_;
    SetUpScratch& s_;
    TriangleCounts& counts_;
    const Draw& draw_;
    const Mesh& mesh_;
    shading::Culling culling_;
    ClipVolume volume_;
    ScreenMap map_;
    int reach_;
    bool has_large_ = false, hides_in_window_ = false;
    std::uint64_t new_bytes_ = 0;   ///< of rows
    std::uint64_t told_bytes_ = 0;  ///< to the picture's memory
};

/// Counting sort of the entries by tile, which keeps their order.
void sort_by_tile(SetUpScratch& s, ChunkTriangles& out) {
    out.sorted.resize(s.entry_count);
    out.runs.clear();
    std::uint32_t sum = 0;
    for (const std::uint32_t tile : s.touched) {
        out.runs.push_back({tile, sum, s.count[tile], false});
        sum += std::exchange(s.count[tile], sum);
    }
    const ScreenTriangle** const sorted = out.sorted.data();
    std::uint32_t* const place = s.count.data();
    for (const SetUpScratch::Entry& e : std::span(s.entries).first(s.entry_count)) sorted[place[e.tile]++] = e.row;
    for (const std::uint32_t tile : s.touched) s.count[tile] = 0;
    s.touched.clear();
}

void note_large(ChunkTriangles& out) {
    for (ChunkRun& run : out.runs) {
        const auto begin = out.sorted.begin() + run.first;
        run.has_large = std::any_of(begin, begin + run.count, [](const ScreenTriangle* t) { return t->is_large; });
    }
}

}  // namespace

ScreenTriangle* RowBlocks::take() {
    const std::lock_guard lock(mutex_);
    if (next_ == blocks_.size()) blocks_.push_back(std::make_unique_for_overwrite<ScreenTriangle[]>(block_rows));
    return blocks_[next_++].get();
}

void set_up_chunk(FrontEnd& front, const TileGrid& grid, const ChunkRange& range, RowBlocks& blocks,
                  SetUpScratch& scratch, ChunkTriangles& out) {
    out.counts = {};
    ChunkSetUp set_up(front, grid, range, blocks, scratch, out.counts);
    set_up.run();
    sort_by_tile(scratch, out);
    out.hides_in_window = set_up.hides_in_window();
    if (set_up.has_large()) note_large(out);
}

}  // namespace rakelight::raster
