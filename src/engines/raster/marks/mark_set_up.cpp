// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/marks/mark_set_up.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "base/hash_key.h"
#include "engines/raster/visibility/depth_formats.h"
#include "shading/culled_triangle.h"

namespace rakelight::raster {
namespace {

/// A vertex in clip space in double.
struct Place {
    double x, y, w, distance;
};

/// An end of a line, with what is affine along it. In clip space this is x, y, w, distance, part; on the screen x, y
/// (px), the depth key and part / w. The part is 0 at the line's first end, 1 at its second.
using ClipEnd = std::array<double, 5>;
using ScreenEnd = std::array<double, 4>;

/// Keeps what lies on one side of a border, `side` * (coordinate - border) >= 0. An end that is cut is found from the
/// other one, so that it costs no digits however far away it was. False: nothing is left.
template <class End>
bool keep(End& a, End& b, std::size_t coordinate, double border, double side) {
    const double at_a = side * (a[coordinate] - border), at_b = side * (b[coordinate] - border);
    if (!(at_a >= 0) && !(at_b >= 0)) return false;
    const auto move = [&](End& end, double at_end, const End& inside, double at_inside) {
        const double part = at_inside / (at_inside - at_end);
        for (std::size_t i = 0; i < end.size(); ++i) end[i] = inside[i] + (end[i] - inside[i]) * part;
        end[coordinate] = border;
    };
    if (!(at_a >= 0)) move(a, at_a, b, at_b);
    if (!(at_b >= 0)) move(b, at_b, a, at_a);
    return true;
}

/// Pairs of vertices that exist already: an edge, in either direction, or a vertex with itself. A file chooses the
/// numbers, so the hash has the key of the run; what is added first does not depend on it.
class SeenEdges {
public:
    explicit SeenEdges(std::size_t most)
        : slots_(std::bit_ceil(2 * most + 2), empty), shift_(64 - std::countr_zero(slots_.size())) {}

    /// True the first time.
    bool add(std::uint32_t a, std::uint32_t b) {
        const std::uint64_t edge = std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
        std::size_t i = folded_product(edge ^ key_.a, key_.b) >> shift_;
        while (slots_[i] != empty && slots_[i] != edge) i = (i + 1) & (slots_.size() - 1);
        return std::exchange(slots_[i], edge) == empty;
    }

private:
    static constexpr std::uint64_t empty = ~std::uint64_t(0);
    std::vector<std::uint64_t> slots_;
    int shift_;
    HashKey key_ = hash_key_of_this_run();
};

/// Sets up the marks of one chunk.
class MarkSetup {
public:
    MarkSetup(FrontEnd& front, const TileGrid& grid, MarkChunk& chunk)
        : front_(front),
          view_(front.view),
          grid_(grid),
          chunk_(chunk),
          mesh_(front.list.scene.meshes[chunk.draw->mesh]),
          seen_(is_of_triangles(chunk.source) ? 3 * (chunk.end - chunk.first) : 0),
          to_camera_(view_.world_to_camera * chunk.draw->to_world),
          culling_(shading::culling_of(front.list, *chunk.draw, front.settings)) {
        const bool is_line = chunk.source == MarkSource::lines || chunk.source == MarkSource::edges;
        shape_ = is_line                                       ? Mark::Shape::line
                 : front.settings.points == PointShape::square ? Mark::Shape::square
                                                               : Mark::Shape::disc;
        reach_ = mark_reach(is_line ? front.settings.line_width : front.settings.point_size);
    }

    void run() {
        for (std::size_t i = chunk_.first; i < chunk_.end; ++i) switch (chunk_.source) {
                case MarkSource::lines:
                    add_line(mesh_.indices[2 * i], mesh_.indices[2 * i + 1]);
                    break;
                case MarkSource::points:
                    add_point(mesh_.indices[i]);
                    break;
                case MarkSource::edges:
                    add_edges(mesh_.indices.data() + 3 * i);
                    break;
                case MarkSource::vertices:
                    add_vertices(mesh_.indices.data() + 3 * i);
                    break;
            }
        front_.memory.add(chunk_.marks.size() * sizeof(Mark) + chunk_.tiles.size() * 2 * sizeof(std::uint64_t));
    }

private:
    static bool is_of_triangles(MarkSource s) { return s == MarkSource::edges || s == MarkSource::vertices; }

    Place place(std::uint32_t vertex) const {
        const dvec3 p = transform_point(to_camera_, cast<double>(mesh_.positions[vertex]));
        return {p.x * view_.scale_x, p.y * view_.scale_y, view_.orthographic ? 1.0 : -p.z, -p.z};
    }

    bool is_culled(const Place (&v)[3]) const {
        return shading::is_culled(culling_,
                                  {{v[0].x, v[0].y, v[0].w}, {v[1].x, v[1].y, v[1].w}, {v[2].x, v[2].y, v[2].w}});
    }

    /// From the vertex of the lower number, whichever of its triangles comes first.
    void add_edges(const std::uint32_t* index) {
        const Place v[3] = {place(index[0]), place(index[1]), place(index[2])};
        if (is_culled(v)) return;
        for (std::size_t k = 0; k < 3; ++k) {
            std::size_t a = k, b = (k + 1) % 3;
            if (!seen_.add(index[a], index[b])) continue;
            if (index[a] > index[b]) std::swap(a, b);
            add(v[a], v[b], index[a], index[b]);
        }
    }
    void add_vertices(const std::uint32_t* index) {
        const Place v[3] = {place(index[0]), place(index[1]), place(index[2])};
        if (is_culled(v)) return;
        for (std::size_t k = 0; k < 3; ++k)
            if (seen_.add(index[k], index[k])) add(v[k], v[k], index[k], index[k]);
    }
    void add_line(std::uint32_t a, std::uint32_t b) { add(place(a), place(b), a, b); }
    void add_point(std::uint32_t a) {
        const Place p = place(a);
        add(p, p, a, a);
    }

    ScreenEnd project(const ClipEnd& c) const {
        const auto [x, y, w, distance, part] = c;
        const double key = reversed_depth(distance, {view_.z_near, view_.z_far, view_.orthographic});
        return {(x / w * 0.5 + 0.5) * view_.width, (0.5 - y / w * 0.5) * view_.height, key, part * weight(key)};
    }
    /// As 1 / w.
    double weight(double key) const { return view_.orthographic || !(key > 0) ? 1 : key; }

    /// Near and far before the division, the sides of the whole picture, with room for the width, after it.
    void add(const Place& a, const Place& b, std::uint32_t vertex_a, std::uint32_t vertex_b) {
        ClipEnd from = {a.x, a.y, a.w, a.distance, 0}, to = {b.x, b.y, b.w, b.distance, 1};
        if (!keep(from, to, 3, view_.z_near, 1) || !keep(from, to, 3, view_.z_far, -1)) return;
        ScreenEnd p = project(from), q = project(to);
        if (!keep(p, q, 0, -reach_, 1) || !keep(p, q, 0, view_.width + reach_, -1) || !keep(p, q, 1, -reach_, 1) ||
            !keep(p, q, 1, view_.height + reach_, -1))
            return;
        Mark m{};
        m.shape = shape_;
        if (!set_end(m, 0, p) || !set_end(m, 1, q)) return;
        m.color[0] = chunk_.color != no_color ? chunk_.color : chunk_.first_color + vertex_a;
        m.color[1] = chunk_.color != no_color ? chunk_.color : chunk_.first_color + vertex_b;
        bin(m);
    }

    /// False where numbers of the file were beyond what doubles hold.
    bool set_end(Mark& m, std::size_t end, const ScreenEnd& p) const {
        const auto [x, y, key, weighted] = p;
        m.x[end] = float(x);
        m.y[end] = float(y);
        m.key[end] = float(key);
        m.part[end] = float(weighted / weight(key));
        return std::isfinite(x) && std::isfinite(y) && std::isfinite(key);
    }

    void bin(const Mark& m) {
        const Window& w = grid_.window;
        const auto low = [&](float a, float b) { return std::floor(double(std::min(a, b)) - reach_); };
        const auto high = [&](float a, float b) { return std::ceil(double(std::max(a, b)) + reach_); };
        const int left = std::max(int(low(m.x[0], m.x[1])), w.x),
                  right = std::min(int(high(m.x[0], m.x[1])), w.x + w.width - 1);
        const int top = std::max(int(low(m.y[0], m.y[1])), w.y),
                  bottom = std::min(int(high(m.y[0], m.y[1])), w.y + w.height - 1);
        if (left > right || top > bottom) return;
        const auto index = std::uint32_t(chunk_.marks.size());
        chunk_.marks.push_back(m);
        for (int ty = top / tile_size; ty <= bottom / tile_size; ++ty)
            for (int tx = left / tile_size; tx <= right / tile_size; ++tx)
                if (touches(m, tx, ty))
                    chunk_.tiles.emplace_back(std::uint32_t((ty - grid_.first_y) * grid_.columns + tx - grid_.first_x),
                                              index);
    }

    /// False where all of the tile lies farther from the line's carrier than it reaches.
    bool touches(const Mark& m, int tx, int ty) const {
        const double dx = double(m.x[1]) - double(m.x[0]), dy = double(m.y[1]) - double(m.y[0]), half = 0.5 * tile_size;
        const double across =
            dx * (ty * tile_size + half - double(m.y[0])) - dy * (tx * tile_size + half - double(m.x[0]));
        return std::fabs(across) <=
               (std::fabs(dx) + std::fabs(dy)) * half + reach_ * std::sqrt(dx * dx + dy * dy) + 1e-3;
    }

    FrontEnd& front_;
    const PictureCamera& view_;
    const TileGrid& grid_;
    MarkChunk& chunk_;
    const Mesh& mesh_;
    SeenEdges seen_;
    dmat4 to_camera_;
    shading::Culling culling_;
    Mark::Shape shape_ = Mark::Shape::line;
    double reach_ = 1;  ///< [px] from the line's middle to the last pixel center that it may cover
};

}  // namespace

void set_up_marks(FrontEnd& front, const TileGrid& grid, MarkChunk& chunk) { MarkSetup(front, grid, chunk).run(); }

}  // namespace rakelight::raster
