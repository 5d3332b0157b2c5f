// SPDX-License-Identifier: Apache-2.0
// Vertices -> clipped lines and points on the screen -> tiles.
#include "engines/raster/marks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engines/raster/depth_formats.h"
#include "math/flush_denormals.h"

namespace rakelight::raster {
namespace {

constexpr std::size_t items_per_chunk = 4096;
constexpr std::uint32_t no_color = none;

/// Which elements of a draw become marks.
enum class Source : std::uint8_t { lines, points, edges, vertices };

struct Chunk {
    const Draw* draw = nullptr;
    Source source = Source::lines;
    std::uint32_t color = no_color;  ///< of all; no_color: the vertices' own, from first_color on
    std::uint32_t first_color = 0;
    std::size_t first = 0, end = 0;  ///< lines, points or triangles
    std::vector<Mark> marks;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> tiles;  ///< (tile, index in `marks`)
};

/// A vertex in clip space in double.
struct Place {
    double x, y, w, distance;
};

/// Sets up the marks of one chunk.
class MarkSetup {
public:
    MarkSetup(FrontEnd& front, const TileGrid& grid, Chunk& chunk)
        : front_(front),
          view_(front.view),
          grid_(grid),
          chunk_(chunk),
          mesh_(front.list.scene.meshes[chunk.draw->mesh]),
          to_camera_(view_.world_to_camera * chunk.draw->to_world) {
        const DrawMaterial& material = front.list.materials[chunk.draw->material];
        const bool two_sided = material.double_sided || material.classical;
        const Cull cull = front.settings.cull;
        cull_back_ = cull == Cull::back || (cull == Cull::automatic && !two_sided);
        cull_front_ = cull == Cull::front;
        front_is_positive_ = (front.settings.front_face == FrontFace::counter_clockwise) != chunk.draw->mirrored;
        const bool is_line = chunk.source == Source::lines || chunk.source == Source::edges;
        shape_ = is_line                                       ? Mark::Shape::line
                 : front.settings.points == PointShape::square ? Mark::Shape::square
                                                               : Mark::Shape::disc;
        reach_ = mark_reach(is_line ? front.settings.line_width : front.settings.point_size);
    }

    void run() {
        for (std::size_t i = chunk_.first; i < chunk_.end; ++i) switch (chunk_.source) {
                case Source::lines:
                    add_line(mesh_.indices[2 * i], mesh_.indices[2 * i + 1]);
                    break;
                case Source::points:
                    add_point(mesh_.indices[i]);
                    break;
                case Source::edges:
                    add_edges(mesh_.indices.data() + 3 * i);
                    break;
                case Source::vertices:
                    add_vertices(mesh_.indices.data() + 3 * i);
                    break;
            }
        front_.memory.add(chunk_.marks.size() * sizeof(Mark) + chunk_.tiles.size() * 2 * sizeof(std::uint64_t));
    }

private:
    Place place(std::uint32_t vertex) const {
        const dvec3 p = transform_point(to_camera_, cast<double>(mesh_.positions[vertex]));
        return {p.x * view_.scale_x, p.y * view_.scale_y, view_.orthographic ? 1.0 : -p.z, -p.z};
    }

    /// By the sign of the triangle's area before the division: right also where it passes through the eye plane.
    bool is_culled(const Place (&v)[3]) const {
        if (!cull_back_ && !cull_front_) return false;
        const double area = v[0].x * (v[1].y * v[2].w - v[2].y * v[1].w) -
                            v[1].x * (v[0].y * v[2].w - v[2].y * v[0].w) + v[2].x * (v[0].y * v[1].w - v[1].y * v[0].w);
        const bool is_back = (area > 0) != front_is_positive_;
        return area == 0 || (is_back ? cull_back_ : cull_front_);
    }

    void add_edges(const std::uint32_t* index) {
        const Place v[3] = {place(index[0]), place(index[1]), place(index[2])};
        if (is_culled(v)) return;
        for (std::size_t k = 0; k < 3; ++k) add(v[k], v[(k + 1) % 3], index[k], index[(k + 1) % 3]);
    }
    void add_vertices(const std::uint32_t* index) {
        const Place v[3] = {place(index[0]), place(index[1]), place(index[2])};
        if (is_culled(v)) return;
        for (std::size_t k = 0; k < 3; ++k) add(v[k], v[k], index[k], index[k]);
    }
    void add_line(std::uint32_t a, std::uint32_t b) { add(place(a), place(b), a, b); }
    void add_point(std::uint32_t a) {
        const Place p = place(a);
        add(p, p, a, a);
    }

    /// Keeps the part of a..b where a coordinate that runs linearly from `a` to `b` is at least 0.
    static void cut(double a, double b, double& t0, double& t1) {
        if (!(a >= 0) && !(b >= 0))
            t1 = -1;  // NaN too
        else if (a < 0)
            t0 = std::max(t0, a / (a - b));
        else if (b < 0)
            t1 = std::min(t1, a / (a - b));
    }

    struct End {
        double x, y, key, part;
    };
    End project(const Place& a, const Place& b, double t) const {
        const auto mix = [t](double u, double v) { return u + (v - u) * t; };
        const double w = mix(a.w, b.w);
        return {(mix(a.x, b.x) / w * 0.5 + 0.5) * view_.width, (0.5 - mix(a.y, b.y) / w * 0.5) * view_.height,
                reversed_depth(mix(a.distance, b.distance), {view_.near, view_.far, view_.orthographic}), t};
    }

    /// Near and far before the division, the sides of the whole picture, with room for the width, after it.
    void add(const Place& a, const Place& b, std::uint32_t vertex_a, std::uint32_t vertex_b) {
        double t0 = 0, t1 = 1;
        cut(a.distance - view_.near, b.distance - view_.near, t0, t1);
        cut(view_.far - a.distance, view_.far - b.distance, t0, t1);
        if (!(t0 <= t1)) return;
        const End p = project(a, b, t0), q = project(a, b, t1);
        double s0 = 0, s1 = 1;
        cut(p.x + reach_, q.x + reach_, s0, s1);
        cut(view_.width + reach_ - p.x, view_.width + reach_ - q.x, s0, s1);
        cut(p.y + reach_, q.y + reach_, s0, s1);
        cut(view_.height + reach_ - p.y, view_.height + reach_ - q.y, s0, s1);
        if (!(s0 <= s1)) return;
        Mark m{};
        m.shape = shape_;
        set_end(m, 0, p, q, s0);
        set_end(m, 1, p, q, s1);
        m.color[0] = chunk_.color != no_color ? chunk_.color : chunk_.first_color + vertex_a;
        m.color[1] = chunk_.color != no_color ? chunk_.color : chunk_.first_color + vertex_b;
        bin(m);
    }

    void set_end(Mark& m, std::size_t end, const End& p, const End& q, double s) const {
        const auto mix = [s](double u, double v) { return u + (v - u) * s; };
        m.x[end] = float(mix(p.x, q.x));
        m.y[end] = float(mix(p.y, q.y));
        const double key = mix(p.key, q.key);
        m.key[end] = float(key);
        // On the screen part / w is affine, and the key is as 1 / w.
        m.part[end] =
            float(view_.orthographic || !(key > 0) ? mix(p.part, q.part) : mix(p.part * p.key, q.part * q.key) / key);
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
    const View& view_;
    const TileGrid& grid_;
    Chunk& chunk_;
    const Mesh& mesh_;
    dmat4 to_camera_;
    bool cull_back_ = false, cull_front_ = false, front_is_positive_ = true;
    Mark::Shape shape_ = Mark::Shape::line;
    double reach_ = 1;  ///< [px] from the line's middle to the last pixel center that it may cover
};

vec4 color_of(const DrawMaterial& m) {
    const float* const c = m.view.base_color;
    return {c[0] + m.view.emission[0], c[1] + m.view.emission[1], c[2] + m.view.emission[2],
            m.view.blend ? c[3] : 1.0f};
}

/// What is to be made, cut by numbers of elements; with the colors.
class MarkPlan {
public:
    MarkPlan(FrontEnd& front, Marks& marks) : front_(front), marks_(marks) {}

    std::vector<Chunk> run() {
        const RenderSettings& s = front_.settings;
        for (const Draw& draw : front_.list.line_draws) {
            const Mesh& mesh = mesh_of(draw);
            const bool is_line = mesh.topology == Topology::lines;
            add(draw, is_line ? Source::lines : Source::points, mesh.indices.size() / (is_line ? 2 : 1),
                own_color(draw));
        }
        const bool is_over = s.surfaces && s.line_color.w == 0;
        for (const auto& [wanted, source] :
             {std::pair{s.edges, Source::edges}, {s.points != PointShape::none, Source::vertices}}) {
            if (!wanted) continue;
            const vec4 color = is_over ? vec4{0, 0, 0, 1} : s.line_color;
            for (const Draw& draw : front_.list.draws)
                add(draw, source, mesh_of(draw).triangle_count(), color.w > 0 ? one(color) : own_color(draw));
        }
        for (std::size_t i = 1; i < marks_.colors.size(); ++i)
            marks_.is_of_one_color = marks_.is_of_one_color && marks_.colors[i] == marks_.colors[0];
        return std::move(chunks_);
    }

private:
    struct Colors {
        std::uint32_t all, first;
    };
    const Mesh& mesh_of(const Draw& draw) const { return front_.list.scene.meshes[draw.mesh]; }

    Colors one(vec4 color) {
        if (marks_.colors.empty() || !(marks_.colors.back() == color)) marks_.colors.push_back(color);
        return {std::uint32_t(marks_.colors.size() - 1), 0};
    }
    /// The material's, times the vertices' where there are any.
    Colors own_color(const Draw& draw) {
        const vec4 color = color_of(front_.list.materials[draw.material]);
        const Block<vec4>& vertices = mesh_of(draw).colors;
        if (vertices.empty()) return one(color);
        front_.memory.add(vertices.size() * sizeof(vec4));
        const auto first = std::uint32_t(marks_.colors.size());
        for (const vec4& v : vertices) marks_.colors.push_back({v.x * color.x, v.y * color.y, v.z * color.z, color.w});
        return {no_color, first};
    }
    void add(const Draw& draw, Source source, std::size_t count, Colors color) {
        for (std::size_t i = 0; i < count; i += items_per_chunk)
            chunks_.push_back({&draw, source, color.all, color.first, i, std::min(count, i + items_per_chunk), {}, {}});
    }

    FrontEnd& front_;
    Marks& marks_;
    std::vector<Chunk> chunks_;
};

void check_size(const char* what, float pixels) {
    if (!(pixels > 0 && pixels <= 256))
        throw Error(ErrorCode::usage, std::string(what) + " must be more than 0 and at most 256 pixels");
}

/// Counting sort by tile, in the order of the chunks.
void sort_into_tiles(std::vector<Chunk>& chunks, std::size_t tiles, Marks& marks) {
    std::uint64_t total = 0;
    std::vector<std::uint64_t> count(tiles + 1, 0);
    for (const Chunk& c : chunks) {
        total += c.tiles.size();
        for (const auto& [tile, index] : c.tiles) ++count[tile + 1];
    }
    if (total > 0xFFFFFFFFull) throw Error(ErrorCode::failed, "too many lines and points for one picture");
    for (std::size_t t = 0; t < tiles; ++t) count[t + 1] += count[t];
    marks.offsets.assign(count.begin(), count.end());
    marks.items.resize(std::size_t(total));
    for (std::size_t c = 0; c < chunks.size(); ++c) {
        for (const auto& [tile, index] : chunks[c].tiles)
            marks.items[std::size_t(count[tile]++)] = std::uint64_t(c) << 32 | index;
        marks.chunks.push_back(std::move(chunks[c].marks));
    }
}

}  // namespace

Marks make_marks(FrontEnd& front, const TileGrid& grid, Context& context) {
    Marks marks;
    check_size("the line width", front.settings.line_width);
    check_size("the point size", front.settings.point_size);
    std::vector<Chunk> chunks = MarkPlan(front, marks).run();
    if (chunks.empty()) return marks;
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        const FlushDenormals guard;
        if (!context.cancelled()) MarkSetup(front, grid, chunks[c]).run();
    });
    context.throw_if_cancelled();
    sort_into_tiles(chunks, grid.count(), marks);
    return marks;
}

}  // namespace rakelight::raster
