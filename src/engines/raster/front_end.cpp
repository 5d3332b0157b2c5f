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

/// Part of one draw, and what comes of it. Chunks are cut by numbers of triangles, never by threads.
struct Chunk {
    std::size_t draw = 0, first = 0, end = 0;
    std::vector<ScreenTriangle> triangles;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> tiles;  ///< (tile, index in `triangles`)
    RenderStats stats;
};

/// Clipping leaves coordinates in the guard band; where its numbers end (w near the smallest float) they stop at its rim.
std::int32_t snap(double px) {
    const double in_band = px > -guard_band_px ? (px < guard_band_px ? px : guard_band_px) : -guard_band_px;
    return std::int32_t(std::floor(in_band * (1 << subpixel_bits) + 0.5));
}

/// Everything that setting up the triangles of one chunk needs.
class Setup {
public:
    Setup(FrontEnd& front, const TileGrid& grid, Chunk& chunk)
        : front_(front), grid_(grid), chunk_(chunk), volume_(front.view), mesh_(front.list.scene.meshes[front.list.draws[chunk.draw].mesh]) {
        const Draw& draw = front.list.draws[chunk.draw];
        const DrawMaterial& material = front.list.materials[draw.material];
        const bool two_sided = material.double_sided || material.classical;
        cull_back_ = front.settings.cull == Cull::back || (front.settings.cull == Cull::automatic && !two_sided);
        cull_front_ = front.settings.cull == Cull::front;
        // With y down a counter-clockwise triangle has negative area; a mirroring placement turns it round once more.
        front_is_negative_ = (front.settings.front_face == FrontFace::counter_clockwise) != draw.mirrored;
    }

    void run() {
        for (std::size_t t = chunk_.first; t < chunk_.end; ++t) add(std::uint32_t(t));
        front_.memory.add(std::exchange(new_bytes_, 0));
    }

private:
    void add(std::uint32_t t) {
        ClipVertex v[3];
        unsigned all = ~0u, any = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            v[k] = front_.clip[chunk_.draw][mesh_.indices[3 * std::size_t(t) + k]];
            const unsigned code = outcode(v[k], volume_);
            all &= code;
            any |= code;
        }
        if (all != 0 || any == ~0u) {
            ++chunk_.stats.culled_outside;
            return;
        }
        EdgePlanes planes;
        if (!edge_planes(v, front_.view, 0, 0, planes)) {
            ++chunk_.stats.culled_degenerate;
            return;
        }
        ScreenTriangle s{};
        set_depth(v, planes, s);
        s.draw = std::uint32_t(chunk_.draw);
        s.triangle = t;
        if (any & cutting_planes)
            add_clipped(v, any & cutting_planes, s);
        else
            add_piece(v[0], v[1], v[2], s);
    }

    void add_clipped(const ClipVertex (&v)[3], unsigned planes, const ScreenTriangle& s) {
        ClipVertex polygon[max_clipped_vertices];
        const std::size_t count = clip_triangle(v, planes, volume_, polygon);
        ++chunk_.stats.clipped;
        for (std::size_t k = 2; k < count; ++k) add_piece(polygon[0], polygon[k - 1], polygon[k], s);
    }

    /// Depth key: near / distance in perspective, the rest of the way to the far plane in parallel views; both are affine on
    /// the screen, so they come from the planes of the whole triangle also where only a piece of it is drawn.
    void set_depth(const ClipVertex (&v)[3], const EdgePlanes& e, ScreenTriangle& s) const {
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
    }

    void add_piece(const ClipVertex& a, const ClipVertex& b, const ClipVertex& c, ScreenTriangle s) {
        const ClipVertex* corners[3] = {&a, &b, &c};
        for (std::size_t k = 0; k < 3; ++k) {
            const dvec2 p = front_.view.screen(*corners[k]);
            s.x[k] = snap(p.x);
            s.y[k] = snap(p.y);
        }
        const std::int64_t area = std::int64_t(s.x[1] - s.x[0]) * (s.y[2] - s.y[0]) - std::int64_t(s.x[2] - s.x[0]) * (s.y[1] - s.y[0]);
        if (area == 0) {
            ++chunk_.stats.culled_degenerate;
            return;
        }
        s.is_back = (area < 0) != front_is_negative_;
        if (s.is_back ? cull_back_ : cull_front_) {
            ++chunk_.stats.culled_back;
            return;
        }
        if (area < 0) {
            std::swap(s.x[1], s.x[2]);
            std::swap(s.y[1], s.y[2]);
        }
        bin(s);
    }

    void bin(const ScreenTriangle& s) {
        const auto [x_low, x_high] = std::minmax({s.x[0], s.x[1], s.x[2]});
        const auto [y_low, y_high] = std::minmax({s.y[0], s.y[1], s.y[2]});
        // Pixels whose center may be inside, in the window.
        const int left = std::max((x_low + 127) >> subpixel_bits, grid_.window.x);
        const int right = std::min((x_high - 128) >> subpixel_bits, grid_.window.x + grid_.window.width - 1);
        const int top = std::max((y_low + 127) >> subpixel_bits, grid_.window.y);
        const int bottom = std::min((y_high - 128) >> subpixel_bits, grid_.window.y + grid_.window.height - 1);
        if (left > right || top > bottom) {
            ++chunk_.stats.culled_outside;
            return;
        }
        ++chunk_.stats.drawn;
        const auto index = std::uint32_t(chunk_.triangles.size());
        chunk_.triangles.push_back(s);
        new_bytes_ += sizeof(ScreenTriangle);
        for (int ty = top / tile_size; ty <= bottom / tile_size; ++ty) {
            for (int tx = left / tile_size; tx <= right / tile_size; ++tx) {
                if (!touches(s, tx, ty)) continue;
                chunk_.tiles.emplace_back(std::uint32_t((ty - grid_.first_y) * grid_.columns + tx - grid_.first_x), index);
                new_bytes_ += sizeof(chunk_.tiles[0]) + sizeof(Binned::items[0]);
            }
            if (new_bytes_ > 1 << 20) front_.memory.add(std::exchange(new_bytes_, 0));
        }
    }

    /// False when one edge has the whole tile on its outer side.
    static bool touches(const ScreenTriangle& s, int tx, int ty) {
        for (int k = 0; k < 3; ++k) {
            const int n = (k + 1) % 3;
            const std::int64_t dx = s.x[n] - s.x[k], dy = s.y[n] - s.y[k];
            const std::int64_t px = std::int64_t(tx) * tile_fixed + (dy < 0 ? tile_fixed : 0);
            const std::int64_t py = std::int64_t(ty) * tile_fixed + (dx > 0 ? tile_fixed : 0);
            if (dx * (py - s.y[k]) - dy * (px - s.x[k]) < 0) return false;
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
Binned sort_into_tiles(std::vector<Chunk>& chunks, std::size_t tiles) {
    Binned binned;
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
        for (const auto& [tile, index] : chunks[c].tiles) binned.items[std::size_t(count[tile]++)] = std::uint64_t(c) << 32 | index;
        binned.chunks.push_back(std::move(chunks[c].triangles));
        chunks[c] = {};
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
    for (std::size_t i = 0; i < 3; ++i) {
        out.ex[i] = rows[i].x / determinant;
        out.ey[i] = rows[i].y / determinant;
        out.e0[i] = rows[i].z / determinant;
    }
    return true;
}

Binned set_up_and_bin(FrontEnd& front, const TileGrid& grid, Context& context) {
    std::vector<Chunk> chunks;
    for (std::size_t d = 0; d < front.list.draws.size(); ++d) {
        if (front.clip[d].empty()) continue;
        const std::size_t triangles = front.list.scene.meshes[front.list.draws[d].mesh].indices.size() / 3;
        for (std::size_t t = 0; t < triangles; t += triangles_per_chunk)
            chunks.push_back({d, t, std::min(triangles, t + triangles_per_chunk), {}, {}, {}});
    }
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        const FlushDenormals guard;
        Setup(front, grid, chunks[c]).run();
    });
    context.throw_if_cancelled();
    for (const Chunk& c : chunks) add_stats(front.stats, c.stats);
    return sort_into_tiles(chunks, grid.count());
}

}  // namespace rakelight::raster
