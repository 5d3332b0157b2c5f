// SPDX-License-Identifier: Apache-2.0
#include "geometry/refine/subdivide.h"

#include "base/assert.h"
#include "geometry/refine/limit_normals.h"
#include "geometry/refine/subdivision_levels.h"
#include "geometry/refine/subdivision_masks.h"
#include "math/linear.h"

namespace rakelight::geometry {
namespace {

namespace Far = OpenSubdiv::Far;

constexpr std::uint64_t max_indices = 0x7FFFFFFF;  // OpenSubdiv uses int indices

/// Computes the points of one level from the previous one.
template <class V>
class NextPoints {
public:
    NextPoints(Scheme scheme, ValueRule rule, const Level& level, int count, const std::vector<V>& points)
        : scheme_(scheme), rule_(rule), level_(level), points_(points), next_(std::size_t(count)) {}

    std::vector<V> run(Context& context) {
        if (scheme_ == Scheme::catmull_clark)
            for_all(level_.GetNumFaces(), context,
                    [&](int f) { next_[std::size_t(level_.GetFaceChildVertex(f))] = middle(f); });
        for_all(level_.GetNumEdges(), context,
                [&](int e) { next_[std::size_t(level_.GetEdgeChildVertex(e))] = of_edge(e); });
        for_all(level_.GetNumVertices(), context,
                [&](int v) { next_[std::size_t(level_.GetVertexChildVertex(v))] = of_vertex(v); });
        return std::move(next_);
    }

private:
    const V& at(int vertex) const { return points_[std::size_t(vertex)]; }

    V middle(int face) const {
        const auto corners = level_.GetFaceVertices(face);
        V sum{};
        for (int i = 0; i < corners.size(); ++i) sum = sum + at(corners[i]);
        return sum * (1.0 / corners.size());
    }

    V of_edge(int edge) const {
        const auto ends = level_.GetEdgeVertices(edge);
        const V sum = at(ends[0]) + at(ends[1]), half = sum * 0.5;
        const auto faces = level_.GetEdgeFaces(edge);
        const double sharpness = double(level_.GetEdgeSharpness(edge));
        if (rule_ == ValueRule::linear || sharpness >= 1 || faces.size() != 2) return half;
        V beside{};
        for (int i = 0; i < 2; ++i)
            beside = beside + (scheme_ == Scheme::loop ? at(opposite(faces[i], ends[0], ends[1]))
                                                       : next_[std::size_t(level_.GetFaceChildVertex(faces[i]))]);
        const V smooth = scheme_ == Scheme::loop ? sum * 0.375 + beside * 0.125 : (sum + beside) * 0.25;
        return sharpness > 0 ? half * sharpness + smooth * (1 - sharpness) : smooth;
    }

    int opposite(int triangle, int a, int b) const {
        const auto corners = level_.GetFaceVertices(triangle);
        int i = 0;
        while (i < 2 && (corners[i] == a || corners[i] == b)) ++i;
        return corners[i];
    }

    V of_vertex(int vertex) const {
        if (rule_ == ValueRule::linear) return at(vertex);
        if (rule_ == ValueRule::fixed_ends && level_.IsVertexBoundary(vertex)) return at(vertex);
        const Corner now = corner_at(level_, vertex, false);
        const V point = by_rule(vertex, now);
        if (now.rule == Rule::smooth) return point;
        const Corner later = corner_at(level_, vertex, true);
        if (later.rule == now.rule) return point;
        const double part = part_of_sharp_rule(level_, vertex);
        return point * part + by_rule(vertex, later) * (1 - part);
    }

    V by_rule(int vertex, const Corner& corner) const {
        if (corner.rule == Rule::corner) return at(vertex);
        if (corner.rule == Rule::crease) return at(vertex) * 0.75 + (at(corner.ends[0]) + at(corner.ends[1])) * 0.125;
        const auto edges = level_.GetVertexEdges(vertex);
        const int n = edges.size();
        V sum{};
        for (int i = 0; i < n; ++i) sum = sum + at(far_end(level_, edges[i], vertex));
        if (scheme_ == Scheme::loop) {
            const double beta = loop_beta(n);
            return at(vertex) * (1 - n * beta) + sum * beta;
        }
        const auto faces = level_.GetVertexFaces(vertex);
        for (int i = 0; i < faces.size(); ++i) sum = sum + next_[std::size_t(level_.GetFaceChildVertex(faces[i]))];
        return at(vertex) * (double(n - 2) / n) + sum * (1.0 / (double(n) * n));
    }

    Scheme scheme_;
    ValueRule rule_;
    const Level& level_;
    const std::vector<V>& points_;
    std::vector<V> next_;
};

/// The limit position of a vertex of the last level, whose faces are quads or triangles.
template <class V>
V limit_point(Scheme scheme, ValueRule rule, const Level& level, int vertex, const std::vector<V>& points) {
    const auto at = [&](int v) -> const V& { return points[std::size_t(v)]; };
    const V p = at(vertex);
    if (rule == ValueRule::linear || (rule == ValueRule::fixed_ends && level.IsVertexBoundary(vertex))) return p;
    const Corner corner = corner_at(level, vertex, false);
    if (corner.rule == Rule::corner) return p;
    if (corner.rule == Rule::crease) return (p * 4.0 + at(corner.ends[0]) + at(corner.ends[1])) * (1.0 / 6);
    const auto edges = level.GetVertexEdges(vertex);
    const double n = edges.size();
    V ring{};
    for (int i = 0; i < edges.size(); ++i) ring = ring + at(far_end(level, edges[i], vertex));
    if (scheme == Scheme::loop) {
        const double w = loop_limit_weight(edges.size());
        return p * (1 - n * w) + ring * w;
    }
    const auto faces = level.GetVertexFaces(vertex);  // Halstead et al. 1993, eq. 1
    const auto local = level.GetVertexFaceLocalIndices(vertex);
    V far{};
    for (int i = 0; i < faces.size(); ++i) far = far + at(level.GetFaceVertices(faces[i])[(local[i] + 2) % 4]);
    return (p * (n * n) + ring * 4.0 + far) * (1 / (n * (n + 5)));
}

/// A point at the last level, and with it every level between.
template <class V>
std::vector<V> points_at_last(const Far::TopologyRefiner& refiner, Scheme scheme, ValueRule rule, std::vector<V> points,
                              Context& context) {
    for (int i = 0; i < refiner.GetMaxLevel(); ++i) {
        context.throw_if_cancelled();
        points = NextPoints<V>(scheme, rule, refiner.GetLevel(i), refiner.GetLevel(i + 1).GetNumVertices(), points)
                     .run(context);
    }
    return points;
}

template <class V>
std::vector<V> limit_points(Scheme scheme, ValueRule rule, const Level& last, const std::vector<V>& points,
                            Context& context) {
    std::vector<V> limit(points.size());
    for_all(last.GetNumVertices(), context,
            [&](int v) { limit[std::size_t(v)] = limit_point(scheme, rule, last, v, points); });
    return limit;
}

std::vector<std::uint32_t> corners_of(const Level& level, std::uint32_t corners_of_face, Context& context) {
    std::vector<std::uint32_t> corners(std::size_t(level.GetNumFaces()) * corners_of_face);
    for_all(level.GetNumFaces(), context, [&](int f) {
        const auto face = level.GetFaceVertices(f);
        for (std::uint32_t k = 0; k < corners_of_face; ++k)
            corners[std::size_t(f) * corners_of_face + k] = std::uint32_t(face[int(k)]);
    });
    return corners;
}

void check_size(const ControlSurface& s) {
    const std::uint64_t faces = fine_face_count(s.scheme, s.level, s.faces);
    RL_ASSERT(s.level >= 1 && s.level <= 10, "subdivision goes by 1 to 10 levels");
    if (faces > max_indices / 4 || s.faces.corners.size() > max_indices || s.positions.size() > max_indices)
        throw Error(ErrorCode::bad_file, "subdivision makes more faces than can be numbered", {}, "use fewer levels");
}

/// Values of the surface's creases and pinned vertices.
Sharpness sharpness_of_values(const ControlSurface& surface, const std::vector<std::uint32_t>& values) {
    auto creases = surface.creases;
    for (auto& [a, b] : creases)
        if (a > b) std::swap(a, b);
    std::sort(creases.begin(), creases.end());
    std::vector<std::uint8_t> is_pinned(surface.positions.size(), 0);
    for (const std::uint32_t v : surface.pinned) is_pinned[v] = 1;
    Sharpness sharpness;
    const Polygons& faces = surface.faces;
    for (std::uint32_t f = 0; f < faces.count(); ++f)
        for (std::uint32_t c = faces.first[f]; c < faces.first[f + 1]; ++c) {
            const std::uint32_t d = faces.next(f, c), a = faces.corners[c], b = faces.corners[d];
            if (is_pinned[a]) sharpness.add_vertex(values[c]);
            if (!creases.empty() &&
                std::binary_search(creases.begin(), creases.end(), std::array{std::min(a, b), std::max(a, b)}))
                sharpness.add_edge(values[c], values[d], surface.sharpness);
        }
    return sharpness;
}

}  // namespace

std::uint64_t fine_face_count(Scheme scheme, int level, const Polygons& faces) {
    return scheme == Scheme::loop ? std::uint64_t(faces.count()) << (2 * level)
                                  : std::uint64_t(faces.corners.size()) << (2 * (level - 1));
}

std::uint64_t subdivision_bytes(Scheme scheme, std::uint64_t fine_faces) {
    return fine_faces * (scheme == Scheme::loop ? 200 : 320);
}

LimitSurface subdivide(const ControlSurface& surface, Context& context) {
    check_size(surface);
    Sharpness sharpness;
    for (const auto& [a, b] : surface.creases) sharpness.add_edge(a, b, surface.sharpness);
    for (const std::uint32_t v : surface.pinned) sharpness.add_vertex(v);
    const auto refiner = refine(surface, surface.faces.corners, surface.positions.size(), sharpness);
    const Level last = refiner->GetLevel(refiner->GetMaxLevel());
    const auto points = points_at_last(*refiner, surface.scheme, ValueRule::smooth, surface.positions, context);
    LimitSurface out;
    out.corners_of_face = surface.scheme == Scheme::loop ? 3 : 4;
    out.positions = limit_points(surface.scheme, ValueRule::smooth, last, points, context);
    out.vertices = corners_of(last, out.corners_of_face, context);
    RL_ASSERT(std::uint64_t(last.GetNumFaces()) == fine_face_count(surface.scheme, surface.level, surface.faces),
              "each face has its children");
    add_limit_normals(surface.scheme, last, points, out, context);
    return out;
}

LimitValues subdivide_values(const ControlSurface& surface, const ControlValues& values, Context& context) {
    check_size(surface);
    const auto refiner =
        refine(surface, values.corners, values.values.size(), sharpness_of_values(surface, values.corners));
    const Level last = refiner->GetLevel(refiner->GetMaxLevel());
    const auto points = points_at_last(*refiner, surface.scheme, values.rule, values.values, context);
    LimitValues out;
    out.values = limit_points(surface.scheme, values.rule, last, points, context);
    out.corners = corners_of(last, surface.scheme == Scheme::loop ? 3 : 4, context);
    return out;
}

}  // namespace rakelight::geometry
