// SPDX-License-Identifier: Apache-2.0
// Stages: faces -> edges and pairs at crowded edges -> normals for faces that are too thin -> bends -> planes.
#include "geometry/creases/bent_edges.h"

#include <algorithm>
#include <cmath>

#include "geometry/faults/edge_uses.h"
#include "geometry/input/face_vote.h"
#include "geometry/input/union_find.h"
#include "geometry/weld/position_grid.h"

namespace rakelight::geometry {
namespace {

constexpr double plane_deg = 0.05;       // neighbors that bend by this are one plane, without any rounding
constexpr double most_slack_deg = 12;    // more rounding than this says nothing about a plane
constexpr double three_sigma = 3;        // of the tilt of two faces of one height whose corners are rounded
constexpr double lies_in = 4;            // roundings: a thin face lies in a plane if no corner is farther from it
constexpr double any_turn_deg = 70;      // a face that rounding may turn so far may have any normal
constexpr std::size_t most_paired = 16;  // more faces at one edge are not paired
constexpr std::uint32_t no_face = 0xffffffffu;

double degrees_of(double y, double x) { return corner_angle(y, x) * (180 / pi); }

class Builder {
public:
    Builder(const PlacedMeshes& placed, const FaceNormals& normals, Context& context)
        : placed_(placed),
          input_(placed.input),
          normals_(normals),
          context_(context),
          error_(position_rounding(placed.input, context)) {}

    BentEdges run() {
        measure_faces();
        find_edges();
        if (any_thin_) anchor_thin_faces();
        measure_bends();
        join_planes();
        return std::move(out_);
    }

private:
    /// Calls body(mesh, triangle) for all faces, in parallel.
    template <class Body>
    void for_each_face(const Body& body) const {
        const std::vector<Chunk> chunks = make_chunks(input_.triangle_base, triangles_per_chunk);
        context_.parallel_for(chunks.size(), [&](std::size_t c) {
            for_each_range(chunks[c], input_.triangle_base,
                           [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
                               for (std::uint32_t t = first; t < last; ++t) body(m, input_.triangle_base[m] + t);
                           });
        });
    }

    void measure_faces() {
        const std::size_t count = input_.triangle_count();
        out_.is_face.assign(count, 0);
        out_.crowded.assign(count, 0);
        out_.area.assign(count, 0);
        out_.edge_of_corner.assign(3 * count, no_edge);
        if (std::ranges::any_of(input_.placements.distinct(), [](const Placement& p) { return p.flip < 0; }))
            out_.is_mirrored.assign(count, 0);
        rounding_deg_.assign(count, 0);
        for_each_face([&](std::uint32_t m, std::uint32_t t) {
            FacePlaces places;
            if (!out_.is_mirrored.empty()) out_.is_mirrored[t] = input_.placements[m].flip < 0;
            out_.is_face[t] = normals_[t] != dvec3{} && face_places(placed_, m, t, places);
            if (!out_.is_face[t]) return;
            const FacePoints f = face_points(input_, t);
            const dvec3 a = f.p[1] - f.p[0], b = f.p[2] - f.p[0];
            const double twice = length(cross(a, b)), longest = std::max({length(a), length(b), length(b - a)});
            out_.area[t] = float(0.5 * twice);
            rounding_deg_[t] = float(degrees_of(three_sigma * error_[m] * longest, twice));
        });
        for (const float r : rounding_deg_) any_thin_ |= double(r) > most_slack_deg;
    }

    void find_edges() {
        out_.edges.reserve(3 * std::size_t(input_.triangle_count()) / 2);
        EdgeUses uses(placed_, context_);
        std::vector<EdgeUse> faces;
        uses.for_each_edge([&](std::uint32_t smaller, std::span<const EdgeUse> all) {
            faces.clear();
            for (const EdgeUse& use : all)
                if (out_.is_face[use.corner / 3]) faces.push_back(use);
            if (faces.size() == 2) add(faces[0].corner, faces[1].corner, false);
            if (faces.size() > 2) add_crowded(uses, smaller, faces);
        });
    }

    void add(std::uint32_t a, std::uint32_t b, bool is_crowded) {
        const std::uint32_t e = std::uint32_t(out_.edges.size());
        out_.edges.push_back({.corner = {a, b}, .is_crowded = is_crowded});
        out_.edge_of_corner[a] = out_.edge_of_corner[b] = e;
    }

    // Pairs faces that use the edge in opposite directions, those with the nearest normals first: the sides of shells,
    // and crossing sheets.
    void add_crowded(const EdgeUses& uses, std::uint32_t smaller, const std::vector<EdgeUse>& faces) {
        struct Pair {
            double cosine;
            std::uint32_t a, b;
        };
        for (const EdgeUse& use : faces) out_.crowded[use.corner / 3] |= std::uint8_t(1u << use.corner % 3);
        if (faces.size() > most_paired) return;
        std::vector<Pair> pairs;
        for (std::size_t i = 0; i < faces.size(); ++i)
            for (std::size_t j = i + 1; j < faces.size(); ++j)
                if (uses.goes_up(smaller, faces[i]) != uses.goes_up(smaller, faces[j]))
                    pairs.push_back({dot(normals_[faces[i].corner / 3], normals_[faces[j].corner / 3]), faces[i].corner,
                                     faces[j].corner});
        std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.cosine > q.cosine; });
        for (const Pair& p : pairs)
            if (out_.edge_of_corner[p.a] == no_edge && out_.edge_of_corner[p.b] == no_edge) add(p.a, p.b, true);
    }

    bool is_thin(std::uint32_t face) const { return double(rounding_deg_[face]) > most_slack_deg; }

    // A face so thin that rounding decides about its normal takes the normal of a neighbor whose plane it lies in, and
    // whose normal rounding can have turned into its own. Neighbors that are thin themselves are followed in the next
    // rounds. Neighbors at a short edge come last: a needle lies in many planes through its tip.
    void anchor_thin_faces() {
        constexpr int rounds = 4;
        anchor_.resize(input_.triangle_count());
        for (std::uint32_t t = 0; t < anchor_.size(); ++t) anchor_[t] = is_thin(t) ? no_face : t;
        for (const double least_share : {0.5, 0.0})
            for (int round = 0; round < rounds; ++round) {
                std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
                for (std::uint32_t t = 0; t < anchor_.size(); ++t)
                    if (anchor_[t] == no_face && out_.is_face[t])
                        if (const std::uint32_t a = anchor_for(t, least_share); a != no_face) found.emplace_back(t, a);
                for (const auto& [face, anchor] : found) anchor_[face] = anchor;
                if (found.empty()) break;
            }
        for (std::uint32_t t = 0; t < anchor_.size(); ++t)
            if (anchor_[t] == no_face) anchor_[t] = t;
    }

    // @param least_share  of the longest edge: neighbors at shorter edges do not count
    std::uint32_t anchor_for(std::uint32_t face, double least_share) const {
        const FacePoints points = face_points(input_, face);
        double edge[3];
        for (std::uint32_t k = 0; k < 3; ++k) edge[k] = length(points.p[(k + 1) % 3] - points.p[k]);
        const double least = least_share * std::max({edge[0], edge[1], edge[2]});
        const double turned = double(rounding_deg_[face]);  // rounding alone turned its normal by no more
        const double reach = lies_in * error_[input_.mesh_of_triangle(face)];
        std::uint32_t best = no_face;
        double best_cosine = -2;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t e = out_.edge_of_corner[3 * face + k];
            if (e == no_edge || edge[k] < least) continue;
            const std::uint32_t other = out_.edges[e].face(out_.edges[e].face(0) == face), anchor = anchor_[other];
            if (anchor == no_face) continue;
            const dvec3 n = normals_[anchor];
            const dvec3 third = points.p[(k + 2) % 3];
            if (std::max(std::fabs(dot(n, third - points.p[k])), std::fabs(dot(n, third - points.p[(k + 1) % 3]))) >
                reach)
                continue;
            const double cosine = dot(n, normals_[face]);
            if (turned < any_turn_deg && degrees_of(length(cross(n, normals_[face])), cosine) > turned) continue;
            if (cosine > best_cosine) best = anchor, best_cosine = cosine;
        }
        return best;
    }

    std::uint32_t anchor_of(std::uint32_t face) const { return anchor_.empty() ? face : anchor_[face]; }

    void measure_bends() {
        constexpr std::size_t step = 1u << 15;
        std::vector<BentEdge>& edges = out_.edges;
        context_.parallel_for((edges.size() + step - 1) / step, [&](std::size_t c) {
            for (std::size_t e = c * step; e < std::min(edges.size(), (c + 1) * step); ++e) measure(edges[e]);
        });
    }

    void measure(BentEdge& e) const {
        const std::uint32_t a = anchor_of(e.face(0)), b = anchor_of(e.face(1));
        const dvec3 n = normals_[a], o = normals_[b];
        const FacePoints other = face_points(input_, e.face(1));
        const std::uint32_t k = e.corner[1] % 3;
        const double bend = degrees_of(length(cross(n, o)), dot(n, o));
        const bool is_concave = dot(n, other.p[(k + 2) % 3] - other.p[k]) > 0;
        e.rounding_deg = std::max(rounding_deg_[a], rounding_deg_[b]);
        e.slack_deg = float(plane_deg + std::min(double(e.rounding_deg), most_slack_deg));
        e.bend_deg = float(is_concave ? -bend : bend);
    }

    void join_planes() {
        UnionFind planes, surfaces;
        planes.reset(input_.triangle_count());
        surfaces.reset(input_.triangle_count());
        for (const BentEdge& e : out_.edges) {
            surfaces.join(e.face(0), e.face(1));
            if (std::fabs(e.bend_deg) <= e.slack_deg) planes.join(e.face(0), e.face(1));
        }
        out_.plane_of.resize(input_.triangle_count());
        out_.surface_of.resize(input_.triangle_count());
        for (std::uint32_t t = 0; t < input_.triangle_count(); ++t)
            out_.plane_of[t] = planes.root(t), out_.surface_of[t] = surfaces.root(t);
    }

    const PlacedMeshes& placed_;
    const AttributeInput& input_;
    const FaceNormals& normals_;
    Context& context_;
    std::vector<double> error_;          // [meshes]
    std::vector<float> rounding_deg_;    // [T] how far rounding may turn a face and its neighbor
    std::vector<std::uint32_t> anchor_;  // [T] the face whose normal counts; empty: each its own
    bool any_thin_ = false;
    BentEdges out_;
};

}  // namespace

BentEdges find_bent_edges(const PlacedMeshes& placed, const FaceNormals& normals, Context& context) {
    return Builder(placed, normals, context).run();
}

}  // namespace rakelight::geometry
