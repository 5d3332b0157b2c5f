// SPDX-License-Identifier: Apache-2.0
#include "geometry/refine/surface_pieces.h"

#include <algorithm>
#include <span>

#include "geometry/input/union_find.h"
#include "math/functions.h"
#include "math/linear.h"

namespace rakelight::geometry {
namespace {

constexpr std::uint32_t nothing = 0xFFFFFFFF;
constexpr std::size_t max_at_an_edge = 64;  ///< edges with more faces are not joined, because pairing is quadratic

/// A corner and the edge that begins at it.
struct EdgeUse {
    std::uint32_t low, high, corner;
    bool operator<(const EdgeUse& o) const {
        return low != o.low ? low < o.low : high != o.high ? high < o.high : corner < o.corner;
    }
};

/// Two uses of an edge in opposite directions.
struct Match {
    double bend;  ///< -cosine of the angle between the faces' normals
    std::uint32_t a, b;
    bool operator<(const Match& o) const { return bend != o.bend ? bend < o.bend : a != o.a ? a < o.a : b < o.b; }
};

class Parting {
public:
    Parting(const Polygons& faces, const std::vector<dvec3>& positions, const PieceOptions& options)
        : faces_(faces), positions_(positions), options_(options), twin_(faces.corners.size(), nothing) {}

    SurfacePieces run() {
        number_faces();
        join_edges();
        number_vertices();
        find_creases();
        pin_meetings();
        return std::move(out_);
    }

private:
    std::uint32_t place(std::uint32_t corner) const { return faces_.corners[corner]; }
    std::uint32_t next(std::uint32_t corner) const { return faces_.next(face_of_[corner], corner); }
    std::uint32_t previous(std::uint32_t corner) const { return faces_.previous(face_of_[corner], corner); }

    void number_faces() {
        face_of_.reserve(faces_.corners.size());
        for (std::uint32_t f = 0; f < faces_.count(); ++f) {
            dvec3 area{};  // Newell's method, relative to the first corner
            const dvec3 origin = positions_[place(faces_.first[f])];
            for (std::uint32_t c = faces_.first[f]; c < faces_.first[f + 1]; ++c) {
                face_of_.push_back(f);
                area += cross(positions_[place(c)] - origin, positions_[place(faces_.next(f, c))] - origin);
            }
            normals_.push_back(normalize_or(area, {0, 0, 0}));
        }
    }

    double cosine(std::uint32_t a, std::uint32_t b) const { return dot(normals_[face_of_[a]], normals_[face_of_[b]]); }

    /// Whether the faces of two uses are each other's reverse.
    bool are_reverse(std::uint32_t a, std::uint32_t b) const {
        if (faces_.size(face_of_[a]) != faces_.size(face_of_[b])) return false;
        for (std::uint32_t i = next(a), k = previous(next(b)); i != a; i = next(i), k = previous(k))
            if (place(i) != place(k)) return false;
        return true;
    }

    void join_edges() {
        std::vector<EdgeUse> uses;
        uses.reserve(faces_.corners.size());
        for (std::uint32_t c = 0; c < faces_.corners.size(); ++c) {
            const std::uint32_t a = place(c), b = place(next(c));
            uses.push_back({std::min(a, b), std::max(a, b), c});
        }
        std::sort(uses.begin(), uses.end());
        for (std::size_t first = 0, end; first < uses.size(); first = end) {
            end = first + 1;
            while (end < uses.size() && uses[end].low == uses[first].low && uses[end].high == uses[first].high) ++end;
            join_edge({uses.data() + first, end - first});
        }
    }

    void join_edge(std::span<const EdgeUse> uses) {
        std::vector<Match>& matches = matches_;
        matches.clear();
        for (const EdgeUse& a : uses.size() <= max_at_an_edge ? uses : std::span<const EdgeUse>{})
            for (const EdgeUse& b : uses)
                if (place(a.corner) == a.low && place(b.corner) == b.high && !are_reverse(a.corner, b.corner))
                    matches.push_back({-cosine(a.corner, b.corner), a.corner, b.corner});
        std::sort(matches.begin(), matches.end());
        std::size_t joined = 0;
        for (const Match& m : matches) {
            if (twin_[m.a] != nothing || twin_[m.b] != nothing) continue;
            twin_[m.a] = m.b;
            twin_[m.b] = m.a;
            joined += 2;
        }
        out_.parted_edges += uses.size() > 1 && (joined < uses.size() || uses.size() > 2);
    }

    void number_vertices() {
        UnionFind fans;
        fans.reset(faces_.corners.size());
        for (std::uint32_t c = 0; c < faces_.corners.size(); ++c)
            if (twin_[c] != nothing) fans.join(c, next(twin_[c]));  // the reverse edge is handled separately
        out_.vertices.assign(faces_.corners.size(), nothing);
        for (std::uint32_t c = 0; c < faces_.corners.size(); ++c) {
            const std::uint32_t root = fans.root(c);  // the smallest: already visited
            if (root == c) {
                out_.vertices[c] = std::uint32_t(out_.place_of.size());
                out_.place_of.push_back(place(c));
            } else {
                out_.vertices[c] = out_.vertices[root];
            }
        }
    }

    void find_creases() {
        const std::vector<std::uint8_t>& hard = options_.is_hard;
        if (options_.crease_angle_rad > pi && hard.empty()) return;
        const double least = options_.crease_angle_rad > pi ? -2 : math::cos(options_.crease_angle_rad);
        for (std::uint32_t c = 0; c < faces_.corners.size(); ++c) {
            const std::uint32_t twin = twin_[c];
            if (twin == nothing || twin < c) continue;
            if (cosine(c, twin) < least || (!hard.empty() && (hard[c] != 0 || hard[twin] != 0)))
                out_.creases.push_back({out_.vertices[c], out_.vertices[next(c)]});
        }
    }

    /// The data that determines the motion of a boundary vertex.
    struct End {
        std::vector<std::uint32_t> neighbors;  ///< places along those edges; of a closed surface all around
        bool is_open = false, is_sharp = false;
        std::uint32_t faces = 0;
        bool operator==(const End&) const = default;
    };

    void pin_meetings() {
        std::vector<std::uint32_t> at_place(positions_.size(), 0);
        for (const std::uint32_t p : out_.place_of) ++at_place[p];
        std::vector<std::uint32_t> number(out_.place_of.size(), nothing), meeting;
        for (std::uint32_t v = 0; v < out_.place_of.size(); ++v)
            if (at_place[out_.place_of[v]] > 1) number[v] = std::uint32_t(meeting.size()), meeting.push_back(v);
        std::vector<End> ends(meeting.size());
        for (std::uint32_t c = 0; c < faces_.corners.size(); ++c)
            if (const std::uint32_t n = number[out_.vertices[c]]; n != nothing) collect(c, ends[n]);
        for (const auto& crease : out_.creases)
            for (const std::uint32_t v : crease)
                if (number[v] != nothing) ends[number[v]].is_sharp = true;
        for (End& end : ends) finish(end);
        std::stable_sort(meeting.begin(), meeting.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return out_.place_of[a] < out_.place_of[b]; });
        for (std::size_t first = 0, end; first < meeting.size(); first = end) {
            const auto end_of = [&](std::size_t i) -> const End& { return ends[number[meeting[i]]]; };
            end = first + 1;
            bool go_on = !end_of(first).is_sharp;
            for (; end < meeting.size() && out_.place_of[meeting[end]] == out_.place_of[meeting[first]]; ++end)
                go_on = go_on && end_of(end) == end_of(first);
            if (!go_on)
                out_.pinned.insert(out_.pinned.end(), meeting.begin() + std::ptrdiff_t(first),
                                   meeting.begin() + std::ptrdiff_t(end));
        }
        std::sort(out_.pinned.begin(), out_.pinned.end());
    }

    void collect(std::uint32_t c, End& end) const {
        ++end.faces;
        const bool is_open[2] = {twin_[c] == nothing, twin_[previous(c)] == nothing};
        const std::uint32_t beside[2] = {place(next(c)), place(previous(c))};
        for (int side = 0; side < 2; ++side) {
            if (is_open[side] && !end.is_open) end.neighbors.clear(), end.is_open = true;
            if (is_open[side] == end.is_open) end.neighbors.push_back(beside[side]);
        }
    }

    void finish(End& end) const {
        std::sort(end.neighbors.begin(), end.neighbors.end());
        if (!end.is_open)
            end.neighbors.erase(std::unique(end.neighbors.begin(), end.neighbors.end()), end.neighbors.end());
        if (end.is_open) end.faces = options_.sharpens_corners && end.faces == 1 ? 1 : 2;
    }

    const Polygons& faces_;
    const std::vector<dvec3>& positions_;
    const PieceOptions& options_;
    std::vector<std::uint32_t> face_of_;  ///< [corners]
    std::vector<std::uint32_t> twin_;     ///< [corners] the use of the edge by the face that is joined there
    std::vector<dvec3> normals_;          ///< [F] unit, or 0
    std::vector<Match> matches_;
    SurfacePieces out_;
};

}  // namespace

SurfacePieces part_surface(const Polygons& faces, const std::vector<dvec3>& positions, const PieceOptions& options) {
    return Parting(faces, positions, options).run();
}

}  // namespace rakelight::geometry
