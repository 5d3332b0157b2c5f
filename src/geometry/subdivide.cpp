// SPDX-License-Identifier: Apache-2.0
// The only source that names OpenSubdiv: Far::TopologyRefiner for the topology, nothing of its evaluation.
#include "geometry/subdivide.h"

#include <opensubdiv/far/error.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>
#include <memory>
#include <mutex>

#include "base/assert.h"
#include "geometry/subdivision_masks.h"
#include "math/linear.h"

namespace rakelight::geometry {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;
using Level = Far::TopologyLevel;

constexpr std::uint64_t most_indices = 0x7FFFFFFF;  // OpenSubdiv numbers with int
constexpr float forever = 10;                       // Sdc::Crease::SHARPNESS_INFINITE

/// Calls body(i) for 0..count-1, whatever the threads.
template <class Body>
void for_all(int count, Context& context, const Body& body) {
    constexpr int run = 4096;
    context.parallel_for(std::size_t(count + run - 1) / run, [&](std::size_t chunk) {
        const int first = int(chunk) * run, end = std::min(count, first + run);
        for (int i = first; i < end; ++i) body(i);
    });
}

Sdc::SchemeType type_of(Scheme scheme) { return scheme == Scheme::loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK; }

struct Sharpness {
    std::vector<int> edges, vertices;
    std::vector<float> of_edges, of_vertices;

    void add_edge(std::uint32_t a, std::uint32_t b, double sharpness) {
        edges.insert(edges.end(), {int(a), int(b)});
        of_edges.push_back(float(std::min(sharpness, double(forever))));
    }
    void add_vertex(std::uint32_t v) {
        vertices.push_back(int(v));
        of_vertices.push_back(forever);
    }
};

/// The library would write to standard output.
void be_quiet() {
    static std::once_flag once;
    std::call_once(once, [] {
        Far::SetErrorCallback([](Far::ErrorType, const char*) {});
        Far::SetWarningCallback([](const char*) {});
    });
}

/// @param corners  [corners of the faces] < count
std::unique_ptr<Far::TopologyRefiner> refine(const ControlSurface& surface, const std::vector<std::uint32_t>& corners,
                                             std::size_t count, const Sharpness& sharpness) {
    be_quiet();
    std::vector<int> sizes, indices(corners.begin(), corners.end());
    for (std::uint32_t f = 0; f < surface.faces.count(); ++f) sizes.push_back(int(surface.faces.size(f)));
    Far::TopologyDescriptor descriptor;
    descriptor.numVertices = int(count);
    descriptor.numFaces = int(sizes.size());
    descriptor.numVertsPerFace = sizes.data();
    descriptor.vertIndicesPerFace = indices.data();
    descriptor.numCreases = int(sharpness.of_edges.size());
    descriptor.creaseVertexIndexPairs = sharpness.edges.data();
    descriptor.creaseWeights = sharpness.of_edges.data();
    descriptor.numCorners = int(sharpness.vertices.size());
    descriptor.cornerVertexIndices = sharpness.vertices.data();
    descriptor.cornerWeights = sharpness.of_vertices.data();
    Sdc::Options rules;
    rules.SetVtxBoundaryInterpolation(surface.sharpens_corners ? Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER
                                                               : Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    std::unique_ptr<Far::TopologyRefiner> refiner(
        Factory::Create(descriptor, Factory::Options(type_of(surface.scheme), rules)));
    if (!refiner)
        throw Error(ErrorCode::bad_file, "the surface cannot be subdivided: too many faces at a vertex or edge");
    Far::TopologyRefiner::UniformOptions options(surface.level);
    options.fullTopologyInLastLevel = true;
    refiner->RefineUniform(options);
    return refiner;
}

enum class Rule { smooth, crease, corner };

/// How sharp it is at a vertex, now or a level later.
struct Corner {
    Rule rule;
    int ends[2];  ///< crease: the far ends of its edges
};

float after_a_level(float sharpness) { return sharpness >= forever ? sharpness : std::max(sharpness - 1, 0.0f); }

int far_end(const Level& level, int edge, int vertex) {
    const auto ends = level.GetEdgeVertices(edge);
    return ends[0] == vertex ? ends[1] : ends[0];
}

/// One sharp edge ends in a dart, which moves as a smooth vertex; DeRose et al. 1998, section 3.
Corner corner_at(const Level& level, int vertex, bool is_later) {
    Corner corner{Rule::smooth, {0, 0}};
    int sharp = 0;
    for (const int edge : {0, 1}) corner.ends[edge] = vertex;
    const auto edges = level.GetVertexEdges(vertex);
    for (int i = 0; i < edges.size(); ++i) {
        const float s = level.GetEdgeSharpness(edges[i]);
        if ((is_later ? after_a_level(s) : s) <= 0) continue;
        if (sharp < 2) corner.ends[sharp] = far_end(level, edges[i], vertex);
        ++sharp;
    }
    const float own = level.GetVertexSharpness(vertex);
    if ((is_later ? after_a_level(own) : own) > 0 || sharp > 2)
        corner.rule = Rule::corner;
    else if (sharp == 2)
        corner.rule = Rule::crease;
    return corner;
}

/// The part that the rule before has where sharpness ends within a level; DeRose et al. 1998, appendix B.
double part_of_sharp_rule(const Level& level, int vertex) {
    double sum = 0;
    int count = 0;
    const auto add = [&](float s) {
        if (s > 0 && after_a_level(s) <= 0) sum += double(s), ++count;
    };
    add(level.GetVertexSharpness(vertex));
    const auto edges = level.GetVertexEdges(vertex);
    for (int i = 0; i < edges.size(); ++i) add(level.GetEdgeSharpness(edges[i]));
    return count > 0 ? std::min(sum / count, 1.0) : 1;
}

/// The points of one level from those of the level before.
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

/// Where a vertex of the last level ends up; the faces are quads or triangles there.
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

/// The faces around a vertex between two sharp edges, or all of them: a normal each.
struct Sector {
    int first = 0, count = 0;  ///< faces, counted on from the first one modulo their number
};

/// Normals of the limit surface at the vertices of the last level.
class LimitNormals {
public:
    LimitNormals(Scheme scheme, const Level& level, const std::vector<dvec3>& points, LimitSurface& out)
        : scheme_(scheme), level_(level), points_(points), out_(out) {}

    void run(Context& context) {
        const int vertices = level_.GetNumVertices();
        std::vector<std::uint32_t> first(std::size_t(vertices) + 1, 0);
        for_all(vertices, context, [&](int v) {
            std::uint32_t& count = first[std::size_t(v) + 1];
            for_each_sector(v, [&](const Sector&) { ++count; });
        });
        for (std::size_t v = 0; v < std::size_t(vertices); ++v) first[v + 1] += first[v];
        out_.normals.resize(first.back());
        out_.normal_of.resize(out_.vertices.size());
        for_all(vertices, context, [&](int v) {
            std::uint32_t number = first[std::size_t(v)];
            for_each_sector(v, [&](const Sector& s) { set(v, s, number++); });
        });
    }

private:
    dvec3 from(int vertex, int edge) const {  // to the far end, at the last level
        return points_[std::size_t(far_end(level_, edge, vertex))] - points_[std::size_t(vertex)];
    }

    template <class Body>
    void for_each_sector(int vertex, const Body& body) const {
        const auto edges = level_.GetVertexEdges(vertex);
        const int faces = level_.GetVertexFaces(vertex).size();
        if (level_.IsVertexNonManifold(vertex)) {  // not in order: each face by itself
            for (int i = 0; i < faces; ++i) body(Sector{i, 1});
            return;
        }
        // Face i lies between the edges i and i + 1, counter-clockwise.
        int start = 0, sharp = 0;
        for (int i = edges.size() - 1; i >= 0; --i)
            if (level_.GetEdgeSharpness(edges[i]) > 0) start = i, ++sharp;
        if (sharp < 2) return body(Sector{0, faces});
        for (int i = start; i < start + faces;) {
            int end = i + 1;
            while (end < start + faces && level_.GetEdgeSharpness(edges[end % edges.size()]) <= 0) ++end;
            body(Sector{i % faces, end - i});
            i = end;
        }
    }

    void set(int vertex, const Sector& sector, std::uint32_t number) const {
        const auto faces = level_.GetVertexFaces(vertex);
        const auto local = level_.GetVertexFaceLocalIndices(vertex);
        dvec3 facets{};
        for (int i = 0; i < sector.count; ++i) {
            const int k = (sector.first + i) % faces.size();
            const std::size_t face = std::size_t(faces[k]) * out_.corners_of_face;
            const auto corner = [&](std::uint32_t after) {
                return out_.positions[out_.vertices[face + (local[k] + after) % out_.corners_of_face]];
            };
            facets += cross(corner(1) - corner(0), corner(out_.corners_of_face - 1) - corner(0));
            out_.normal_of[face + local[k]] = number;
        }
        out_.normals[number] = normalize_or(normal_of(vertex, sector, facets), normalize_or(facets, {0, 0, 1}));
    }

    /// Of any length; 0 where the tangents say nothing.
    dvec3 normal_of(int vertex, const Sector& sector, dvec3 facets) const {
        if (level_.IsVertexNonManifold(vertex)) return facets;
        const Corner corner = corner_at(level_, vertex, false);
        if (corner.rule == Rule::smooth) return smooth_normal(vertex);
        const auto edges = level_.GetVertexEdges(vertex);
        const dvec3 first = from(vertex, edges[sector.first]);
        const dvec3 last = from(vertex, edges[(sector.first + sector.count) % edges.size()]);
        if (corner.rule == Rule::crease && sector.count <= most_with_tangents(scheme_))
            return towards(cross(first - last, across(vertex, sector, first, last)), facets);
        if (corner.rule == Rule::crease) return facets;
        // A corner: its edges span the tangent plane, where they are not nearly one line
        const dvec3 normal = cross(first, last);
        const bool is_clear = dot(normal, normal) > 0.01 * dot(first, first) * dot(last, last);
        return is_clear && sector.count < 3 ? towards(normal, facets) : facets;
    }

    /// With more faces on one side of a crease the largest eigenvalues (after 1) are both of the inside: the surface
    /// has no tangent plane there that holds the crease (Biermann, Levin & Zorin 2000, section 3).
    static int most_with_tangents(Scheme scheme) { return scheme == Scheme::loop ? 5 : 3; }

    static dvec3 towards(dvec3 normal, dvec3 way) { return dot(normal, way) < 0 ? -normal : normal; }

    dvec3 smooth_normal(int vertex) const {
        const auto edges = level_.GetVertexEdges(vertex);
        const int n = edges.size();
        const double of_edge = scheme_ == Scheme::loop ? 1 : catmull_clark_edge_weight(n);
        const auto faces = level_.GetVertexFaces(vertex);
        const auto local = level_.GetVertexFaceLocalIndices(vertex);
        dvec3 u{}, v{};
        double c = 1, s = 0;
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * pi * (i + 1) / n, c_next = math::cos(angle), s_next = math::sin(angle);
            const dvec3 e = from(vertex, edges[i]) * of_edge;
            u += e * c;
            v += e * s;
            if (scheme_ == Scheme::catmull_clark) {
                const dvec3 f = far_corner(faces[i], local[i]) - points_[std::size_t(vertex)];
                u += f * (c + c_next);
                v += f * (s + s_next);
            }
            c = c_next, s = s_next;
        }
        return cross(u, v);
    }

    dvec3 far_corner(int quad, int local) const {
        return points_[std::size_t(level_.GetFaceVertices(quad)[(local + 2) % 4])];
    }

    /// Into the sector, across the crease. With a single face it is the way that the crease itself bends: what else
    /// there is shrinks faster from level to level.
    dvec3 across(int vertex, const Sector& sector, dvec3 first, dvec3 last) const {
        if (sector.count == 1) return first + last;
        const AcrossWeights w =
            scheme_ == Scheme::loop ? loop_across_weights(sector.count) : catmull_clark_across_weights(sector.count);
        const auto edges = level_.GetVertexEdges(vertex);
        const auto faces = level_.GetVertexFaces(vertex);
        const auto local = level_.GetVertexFaceLocalIndices(vertex);
        dvec3 sum = (first + last) * w.ends;
        for (int i = 0; i < sector.count; ++i) {
            const int k = (sector.first + i) % faces.size();
            if (i > 0)
                sum += from(vertex, edges[(sector.first + i) % edges.size()]) *
                       (w.edge * math::sin(i * pi / sector.count));
            if (scheme_ == Scheme::catmull_clark)
                sum += (far_corner(faces[k], local[k]) - points_[std::size_t(vertex)]) *
                       (w.face * math::sin((i + 0.5) * pi / sector.count));
        }
        return sum;
    }

    Scheme scheme_;
    const Level& level_;
    const std::vector<dvec3>& points_;
    LimitSurface& out_;
};

void check_size(const ControlSurface& s) {
    const std::uint64_t faces = fine_face_count(s.scheme, s.level, s.faces);
    RL_ASSERT(s.level >= 1 && s.level <= 10, "subdivision goes by 1 to 10 levels");
    if (faces > most_indices / 4 || s.faces.corners.size() > most_indices || s.positions.size() > most_indices)
        throw Error(ErrorCode::bad_file, "subdivision makes more faces than can be numbered", {}, "use fewer levels");
}

/// The surface's creases and pinned vertices, where its values are.
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
    LimitNormals(surface.scheme, last, points, out).run(context);
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
