// SPDX-License-Identifier: Apache-2.0
#include "geometry/faults/t_junctions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rakelight::geometry {
namespace {

constexpr double relative_tolerance = 1e-5;
constexpr std::size_t leaf_points = 8;
constexpr std::uint64_t few_edges = 1024;  // exempt from the work bound

struct Point {
    dvec3 position;
    std::uint32_t place;
};

struct Segment {
    dvec3 from, along;      ///< along: vector to its other end
    double tolerance = 0;   ///< [m]
    std::uint32_t face[3];  ///< places that are no T-junction on it
};

struct Box {
    dvec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
    void add(dvec3 p) {
        low = min(low, p);
        high = max(high, p);
    }
    /// Whether the segment comes within its tolerance (by slabs, Kay & Kajiya 1986).
    bool meets(const Segment& s) const {
        double enter = 0, leave = 1;
        for (std::size_t a = 0; a < 3; ++a) {
            const double below = low[a] - s.tolerance - s.from[a], above = high[a] + s.tolerance - s.from[a];
            if (s.along[a] == 0) {
                if (below > 0 || above < 0) return false;
                continue;
            }
            const double t0 = below / s.along[a], t1 = above / s.along[a];
            enter = std::fmax(enter, std::fmin(t0, t1));
            leave = std::fmin(leave, std::fmax(t0, t1));
        }
        return enter <= leave;
    }
};

bool lies_inside(const Segment& s, const Point& p) {
    for (const std::uint32_t place : s.face)
        if (place == p.place) return false;
    const double square = dot(s.along, s.along), size = std::sqrt(square);
    const double t = dot(p.position - s.from, s.along) / square;
    const dvec3 off = p.position - s.from - s.along * t;
    return t * size > s.tolerance && (1 - t) * size > s.tolerance && dot(off, off) <= s.tolerance * s.tolerance;
}

/// A balanced tree of boxes in heap order. Found points are removed, because many edges over many points would
/// otherwise take quadratic time.
class PointTree {
public:
    explicit PointTree(std::vector<Point> points) : points_(std::move(points)) {
        while ((points_.size() >> levels_) > leaf_points) ++levels_;
        first_leaf_ = (std::size_t(1) << levels_) - 1;
        boxes_.resize(2 * first_leaf_ + 1);
        left_.resize(boxes_.size());
        for (std::size_t node = 0; node < boxes_.size(); ++node) build(node);
        found_.assign(points_.size(), 0);
    }

    const Box& bounds() const { return boxes_[0]; }
    std::uint64_t visits() const { return visits_; }

    /// Removes the points inside the segment and calls body(place) for each.
    template <class Body>
    void take(const Segment& segment, const Body& body) {
        stack_.assign(1, 0);
        while (!stack_.empty()) {
            const std::size_t node = stack_.back();
            stack_.pop_back();
            ++visits_;
            if (left_[node] == 0 || !boxes_[node].meets(segment)) continue;
            if (node < first_leaf_) {
                stack_.push_back(2 * node + 2);
                stack_.push_back(2 * node + 1);
                continue;
            }
            for (std::size_t i = begin_of(node); i < begin_of(node + 1); ++i) {
                if (found_[i] || !lies_inside(segment, points_[i])) continue;
                found_[i] = 1;
                for (std::size_t up = node;; up = (up - 1) / 2) {
                    --left_[up];
                    if (up == 0) break;
                }
                body(points_[i].place);
            }
        }
    }

private:
    // Leaf l of L holds points [l * n / L, (l + 1) * n / L); an inner node those of its leaves.
    std::size_t begin_of_leaf(std::size_t leaf) const { return (leaf * points_.size()) >> levels_; }
    std::size_t begin_of(std::size_t leaf_node) const { return begin_of_leaf(leaf_node - first_leaf_); }

    void build(std::size_t node) {
        std::size_t first = node, last = node;
        while (first < first_leaf_) first = 2 * first + 1, last = 2 * last + 2;
        const auto begin = points_.begin() + std::ptrdiff_t(begin_of(first));
        const auto end = points_.begin() + std::ptrdiff_t(begin_of(last + 1));
        Box& box = boxes_[node];
        std::for_each(begin, end, [&](const Point& p) { box.add(p.position); });
        left_[node] = std::uint32_t(end - begin);
        if (node >= first_leaf_) return;
        const dvec3 size = box.high - box.low;
        const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        std::size_t middle = 2 * node + 2;
        while (middle < first_leaf_) middle = 2 * middle + 1;
        std::nth_element(
            begin, points_.begin() + std::ptrdiff_t(begin_of(middle)), end, [&](const Point& a, const Point& b) {
                return a.position[axis] != b.position[axis] ? a.position[axis] < b.position[axis] : a.place < b.place;
            });
    }

    std::vector<Point> points_;
    std::size_t levels_ = 0, first_leaf_ = 0;
    std::vector<Box> boxes_;
    std::vector<std::uint32_t> left_;  ///< remaining points
    std::vector<std::uint8_t> found_;
    std::vector<std::size_t> stack_;
    std::uint64_t visits_ = 0;
};

/// Ends of an edge and the third corner, as places.
void places_of_edge(const PlacedMeshes& placed, std::uint32_t corner, std::uint32_t (&out)[3]) {
    const std::uint32_t m = placed.input.mesh_of_triangle(corner / 3), first = corner - corner % 3;
    for (std::uint32_t k = 0; k < 3; ++k)
        out[k] = placed.place[placed.input.corner_vertex(m, first + (corner % 3 + k) % 3)];
}

std::vector<Point> ends_of_edges(const PlacedMeshes& placed, std::span<const std::uint32_t> corners) {
    std::vector<std::uint32_t> places;
    std::uint32_t face[3];
    for (const std::uint32_t corner : corners) {
        places_of_edge(placed, corner, face);
        places.insert(places.end(), {face[0], face[1]});
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::vector<Point> points;
    points.reserve(places.size());
    for (const std::uint32_t place : places) points.push_back({placed.position(place), place});
    return points;
}

}  // namespace

TJunctions find_t_junctions(const PlacedMeshes& placed, std::span<const std::uint32_t> open_corners,
                            std::uint32_t objects, std::size_t max_places, const Context& context,
                            std::uint64_t visits_per_edge) {
    TJunctions result;
    result.of_objects.assign(objects, 0);
    if (open_corners.empty()) return result;
    PointTree tree(ends_of_edges(placed, open_corners));
    const double diagonal = length(tree.bounds().high - tree.bounds().low);
    if (!(diagonal < std::numeric_limits<float>::max())) {
        result.edges_not_searched = open_corners.size();
        return result;
    }
    const double rounding = 4 * (double(std::nextafter(float(diagonal), INFINITY)) - double(float(diagonal)));
    const std::uint64_t max_visits = visits_per_edge * (few_edges + open_corners.size());
    for (std::size_t i = 0; i < open_corners.size(); ++i) {
        if (i % 64 == 0) context.throw_if_cancelled();
        if (tree.visits() > max_visits) {
            result.edges_not_searched = open_corners.size() - i;
            break;
        }
        Segment segment;
        places_of_edge(placed, open_corners[i], segment.face);
        segment.from = placed.position(segment.face[0]);
        segment.along = placed.position(segment.face[1]) - segment.from;
        segment.tolerance = std::fmax(rounding, relative_tolerance * length(segment.along));
        tree.take(segment, [&](std::uint32_t place) {
            ++result.of_objects[placed.object_of_triangle(open_corners[i] / 3)];
            result.places.push_back({place, open_corners[i]});
        });
    }
    result.count = result.places.size();
    std::sort(result.places.begin(), result.places.end(), [](TJunction a, TJunction b) { return a.place < b.place; });
    if (result.places.size() > max_places) result.places.resize(max_places);
    return result;
}

}  // namespace rakelight::geometry
