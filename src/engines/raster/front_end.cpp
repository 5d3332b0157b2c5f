// SPDX-License-Identifier: Apache-2.0
// Triangles: clipping -> screen -> culling -> tiles.
#include "engines/raster/front_end.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "math/flush_denormals.h"

namespace rakelight::raster {
namespace {

constexpr std::size_t triangles_per_chunk = 4096;
constexpr int tile_fixed = tile_size << subpixel_bits;
constexpr unsigned outside_all = 0xffffu;  // outcode() of what is not finite, as it is kept

/// Part of one draw, and what comes of it. Chunks are cut by numbers of triangles, never by threads.
struct Chunk {
    std::size_t draw = 0, first = 0, end = 0;
    std::vector<ScreenTriangle> triangles;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> tiles;  ///< (tile, index in `triangles`)
    RenderStats stats;
};

/// Everything that setting up the triangles of one chunk needs.
class Setup {
public:
    Setup(FrontEnd& front, const TileGrid& grid, Chunk& chunk)
        : front_(front),
          grid_(grid),
          chunk_(chunk),
          volume_(front.view),
          mesh_(front.list.scene.meshes[front.list.draws[chunk.draw].mesh]) {
        const Draw& draw = front.list.draws[chunk.draw];
        const DrawMaterial& material = front.list.materials[draw.material];
        const bool two_sided = material.double_sided || material.classical;
        cull_back_ = front.settings.cull == Cull::back || (front.settings.cull == Cull::automatic && !two_sided);
        cull_front_ = front.settings.cull == Cull::front;
        // With y down a counter-clockwise triangle has negative area; a mirroring placement turns it round once more.
        front_is_negative_ = (front.settings.front_face == FrontFace::counter_clockwise) != draw.mirrored;
    }

    void run() {
        chunk_.triangles.reserve(chunk_.end - chunk_.first);
        chunk_.tiles.reserve(chunk_.end - chunk_.first);
        for (std::size_t t = chunk_.first; t < chunk_.end; ++t) add(std::uint32_t(t));
        front_.memory.add(std::exchange(new_bytes_, 0));
    }

private:
    /// The pixels whose center may be inside, in the window.
    struct Box {
        int left, right, top, bottom;
    };

    void add(std::uint32_t t) {
        const std::uint32_t* const index = mesh_.indices.data() + 3 * std::size_t(t);
        const ClipVertices& clip = front_.clip[chunk_.draw];
        if (!front_.codes[chunk_.draw].empty() && !is_uncut(t, index)) return;
        const std::vector<ScreenPoint>& screen = front_.screen[chunk_.draw];
        const ScreenPoint points[3] = {screen[index[0]], screen[index[1]], screen[index[2]]};
        ScreenTriangle s = triangle(t);
        Box box;
        if (!place(points, s, box)) return;
        const ClipVertex v[3] = {clip[index[0]], clip[index[1]], clip[index[2]]};
        if (set_depth(v, s)) bin(s, box);
    }

    ScreenTriangle triangle(std::uint32_t t) const {
        ScreenTriangle s{};
        s.draw = std::uint32_t(chunk_.draw);
        s.triangle = t;
        return s;
    }

    /// False when the triangle is outside, or was cut and added.
    bool is_uncut(std::uint32_t t, const std::uint32_t* index) {
        const std::vector<std::uint16_t>& codes = front_.codes[chunk_.draw];
        const unsigned all = codes[index[0]] & codes[index[1]] & codes[index[2]],
                       any = codes[index[0]] | codes[index[1]] | codes[index[2]];
        if (all != 0 || any == outside_all) {
            ++chunk_.stats.culled_outside;
            return false;
        }
        if ((any & cutting_planes) == 0) return true;
        const ClipVertices& clip = front_.clip[chunk_.draw];
        const ClipVertex v[3] = {clip[index[0]], clip[index[1]], clip[index[2]]};
        ScreenTriangle s = triangle(t);
        if (set_depth(v, s)) add_clipped(v, any & cutting_planes, s);
        return false;
    }

    void add_clipped(const ClipVertex (&v)[3], unsigned planes, const ScreenTriangle& s) {
        ClipVertex polygon[max_clipped_vertices];
        const std::size_t count = clip_triangle(v, planes, volume_, polygon);
        ++chunk_.stats.clipped;
        for (std::size_t k = 2; k < count; ++k) {
            const ScreenPoint points[3] = {snap_to_screen(front_.view, polygon[0]),
                                           snap_to_screen(front_.view, polygon[k - 1]),
                                           snap_to_screen(front_.view, polygon[k])};
            ScreenTriangle piece = s;
            piece.is_piece = true;
            Box box;
            if (place(points, piece, box)) bin(piece, box);
        }
    }

    /// Depth key: near / distance in perspective, the rest of the way to the far plane in parallel views; both are
    /// affine on the screen, so they come from the planes of the whole triangle also where only a piece of it is drawn.
    bool set_depth(const ClipVertex (&v)[3], ScreenTriangle& s) {
        EdgePlanes e;
        if (!edge_planes(v, front_.view, 0, 0, e)) {
            ++chunk_.stats.culled_degenerate;
            return false;
        }
        const double near = front_.view.near, range = front_.view.far - near;
        double key[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const double weight = front_.view.orthographic ? 1 - (double(v[i].distance) - near) / range : near;
            s.depth_x += e.ex[i] * weight;
            s.depth_y += e.ey[i] * weight;
            s.depth_0 += e.e0[i] * weight;
            key[i] = front_.view.orthographic ? weight : v[i].distance > near ? near / double(v[i].distance) : 1.0;
        }
        s.depth_low = float(std::min({key[0], key[1], key[2]}));
        s.depth_high = float(std::max({key[0], key[1], key[2]}));
        return true;
    }

    /// Corners in order of positive area, and the box; false: culled, and counted.
    bool place(const ScreenPoint (&p)[3], ScreenTriangle& s, Box& box) {
        const std::int64_t area =
            std::int64_t(p[1].x - p[0].x) * (p[2].y - p[0].y) - std::int64_t(p[2].x - p[0].x) * (p[1].y - p[0].y);
        if (area == 0) {
            ++chunk_.stats.culled_degenerate;
            return false;
        }
        s.is_back = (area < 0) != front_is_negative_;
        if (s.is_back ? cull_back_ : cull_front_) {
            ++chunk_.stats.culled_back;
            return false;
        }
        const std::size_t second = area < 0 ? 2 : 1, third = 3 - second;
        s.is_swapped = area < 0;
        s.x0 = p[0].x, s.x1 = p[second].x, s.x2 = p[third].x;
        s.y0 = p[0].y, s.y1 = p[second].y, s.y2 = p[third].y;
        const auto [x_low, x_high] = std::minmax({p[0].x, p[1].x, p[2].x});
        const auto [y_low, y_high] = std::minmax({p[0].y, p[1].y, p[2].y});
        box.left = std::max((x_low + 127) >> subpixel_bits, grid_.window.x);
        box.right = std::min((x_high - 128) >> subpixel_bits, grid_.window.x + grid_.window.width - 1);
        box.top = std::max((y_low + 127) >> subpixel_bits, grid_.window.y);
        box.bottom = std::min((y_high - 128) >> subpixel_bits, grid_.window.y + grid_.window.height - 1);
        if (box.left <= box.right && box.top <= box.bottom) return true;
        ++chunk_.stats.culled_outside;
        return false;
    }

    void bin(const ScreenTriangle& s, const Box& box) {
        ++chunk_.stats.drawn;
        const auto index = std::uint32_t(chunk_.triangles.size());
        chunk_.triangles.push_back(s);
        new_bytes_ += sizeof(ScreenTriangle);
        const int first_x = box.left / tile_size, last_x = box.right / tile_size;
        const int first_y = box.top / tile_size, last_y = box.bottom / tile_size;
        const bool is_in_one = first_x == last_x && first_y == last_y;
        for (int ty = first_y; ty <= last_y; ++ty) {
            for (int tx = first_x; tx <= last_x; ++tx) {
                if (!is_in_one && !touches(s, tx, ty)) continue;
                chunk_.tiles.emplace_back(std::uint32_t((ty - grid_.first_y) * grid_.columns + tx - grid_.first_x),
                                          index);
                new_bytes_ += sizeof(chunk_.tiles[0]) + sizeof(Binned::items[0]);
            }
            if (new_bytes_ > 1 << 20) front_.memory.add(std::exchange(new_bytes_, 0));
        }
    }

    /// False when one edge has the whole tile on its outer side.
    static bool touches(const ScreenTriangle& s, int tx, int ty) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t n = (k + 1) % 3;
            const std::int64_t dx = s.x(n) - s.x(k), dy = s.y(n) - s.y(k);
            const std::int64_t px = std::int64_t(tx) * tile_fixed + (dy < 0 ? tile_fixed : 0);
            const std::int64_t py = std::int64_t(ty) * tile_fixed + (dx > 0 ? tile_fixed : 0);
            if (dx * (py - s.y(k)) - dy * (px - s.x(k)) < 0) return false;
        }
        return true;
    }

    FrontEnd& front_;
    const TileGrid& grid_;
    Chunk& chunk_;
    std::uint64_t new_bytes_ = 0;  ///< not yet told to the picture's memory
    ClipVolume volume_;
    const Mesh& mesh_;
    bool cull_back_ = false, cull_front_ = false, front_is_negative_ = true;
};

void add_stats(RenderStats& sum, const RenderStats& part) {
    sum.culled_back += part.culled_back;
    sum.culled_degenerate += part.culled_degenerate;
    sum.culled_outside += part.culled_outside;
    sum.clipped += part.clipped;
    sum.drawn += part.drawn;
}

/// Counting sort of all chunks' entries by tile, in the order of the chunks.
Binned sort_into_tiles(std::vector<Chunk>& chunks, std::size_t tiles, Binned&& used) {
    Binned binned = std::move(used);
    binned.chunks.clear();
    binned.spare.clear();
    std::vector<std::uint64_t> count(tiles + 1, 0);
    std::uint64_t total = 0;
    for (const Chunk& c : chunks) total += c.tiles.size();
    if (total > 0xFFFFFFFFull) throw Error(ErrorCode::failed, "too many triangles for one picture");
    for (const Chunk& c : chunks)
        for (const auto& [tile, index] : c.tiles) ++count[tile + 1];
    for (std::size_t t = 0; t < tiles; ++t) count[t + 1] += count[t];
    binned.offsets.assign(count.begin(), count.end());
    binned.items.resize(std::size_t(total));
    for (std::size_t c = 0; c < chunks.size(); ++c) {
        for (const auto& [tile, index] : chunks[c].tiles)
            binned.items[std::size_t(count[tile]++)] = std::uint64_t(c) << 32 | index;
        binned.chunks.push_back(std::move(chunks[c].triangles));
        binned.spare.push_back(std::move(chunks[c].tiles));
    }
    return binned;
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
    std::vector<Chunk> chunks;
    for (std::size_t d = 0; d < front.list.draws.size(); ++d) {
        if (front.clip[d].empty()) continue;
        const std::size_t triangles = front.list.scene.meshes[front.list.draws[d].mesh].indices.size() / 3;
        for (std::size_t t = 0; t < triangles; t += triangles_per_chunk)
            chunks.push_back({d, t, std::min(triangles, t + triangles_per_chunk), {}, {}, {}});
    }
    for (std::size_t c = 0; c < std::min(chunks.size(), used.chunks.size()); ++c) {
        chunks[c].triangles = std::move(used.chunks[c]);
        chunks[c].tiles = std::move(used.spare[c]);
        chunks[c].triangles.clear();
        chunks[c].tiles.clear();
    }
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        const FlushDenormals guard;
        Setup(front, grid, chunks[c]).run();
    });
    context.throw_if_cancelled();
    for (const Chunk& c : chunks) add_stats(front.stats, c.stats);
    return sort_into_tiles(chunks, grid.count(), std::move(used));
}

}  // namespace rakelight::raster
