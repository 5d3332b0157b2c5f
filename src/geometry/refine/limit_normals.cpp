// SPDX-License-Identifier: Apache-2.0
#include "geometry/refine/limit_normals.h"

#include "geometry/refine/subdivision_masks.h"
#include "math/linear.h"

namespace rakelight::geometry {
namespace {

/// A sector: the faces around a vertex between two sharp edges, or all faces. Each has one normal.
struct Sector {
    int first = 0, count = 0;  ///< faces, cyclic from the first one
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
        if (level_.IsVertexNonManifold(vertex)) {  // non-manifold: each face separately
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

    /// Not normalized; 0 if the tangents are degenerate.
    dvec3 normal_of(int vertex, const Sector& sector, dvec3 facets) const {
        if (level_.IsVertexNonManifold(vertex)) return facets;
        const Corner corner = corner_at(level_, vertex, false);
        if (corner.rule == Rule::smooth) return smooth_normal(vertex);
        const auto edges = level_.GetVertexEdges(vertex);
        const dvec3 first = from(vertex, edges[sector.first]);
        const dvec3 last = from(vertex, edges[(sector.first + sector.count) % edges.size()]);
        if (corner.rule == Rule::crease && sector.count <= max_with_tangents(scheme_))
            return towards(cross(first - last, across(vertex, sector, first, last)), facets);
        if (corner.rule == Rule::crease) return facets;
        // a corner: its edges span the tangent plane unless nearly collinear
        const dvec3 normal = cross(first, last);
        const bool is_clear = dot(normal, normal) > 0.01 * dot(first, first) * dot(last, last);
        return is_clear && sector.count < 3 ? towards(normal, facets) : facets;
    }

    /// With more faces on one side of a crease the largest eigenvalues (after 1) are both of the inside. Then the
    /// surface has no tangent plane there that holds the crease (Biermann, Levin & Zorin 2000, section 3).
    static int max_with_tangents(Scheme scheme) { return scheme == Scheme::loop ? 5 : 3; }

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
}  // namespace

void add_limit_normals(Scheme scheme, const Level& level, const std::vector<dvec3>& points, LimitSurface& out,
                       Context& context) {
    LimitNormals(scheme, level, points, out).run(context);
}

}  // namespace rakelight::geometry
