// SPDX-License-Identifier: Apache-2.0
#include "geometry/borders/border_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/cancel_check.h"
#include "geometry/groups/authored_normals.h"
#include "geometry/groups/join_rules.h"

namespace rakelight::geometry {
namespace {

constexpr std::size_t leaf_edges = 4;
constexpr std::uint32_t max_visits = 512;    // boxes and edges per query
constexpr double cosine_of_opposite = -0.5;  // edges run in opposite directions within 60 degrees
constexpr double overlap_share = 0.5;        // of the distance: maximum overlap of faces
constexpr double normal_share = 0.25;        // of the distance: rank penalty of a deviating normal
constexpr double infinite = std::numeric_limits<double>::infinity();

double square_distance(dvec3 p, dvec3 low, dvec3 high) {
    const dvec3 off = max(max(low - p, p - high), dvec3{0, 0, 0});
    return dot(off, off);
}

}  // namespace

struct BorderSearch::Question {
    const BorderEdge& own;
    dvec3 point, normal;
    double radius;
};

BorderSearch::BorderSearch(std::span<const BorderEdge> edges, const AttributeInput& input, const MatchOptions& options,
                           Context& context)
    : edges_(edges), input_(input), options_(options), order_(edges.size()) {
    for (const AttributeMesh& mesh : input.meshes)
        cosines_.push_back(crease_cosine(mesh.crease_angle_rad < 0 ? options.crease_angle_rad : mesh.crease_angle_rad));
    std::iota(order_.begin(), order_.end(), 0u);
    while ((edges.size() >> levels_) > leaf_edges) ++levels_;
    first_leaf_ = (std::size_t(1) << levels_) - 1;
    boxes_.resize(2 * first_leaf_ + 1);
    CancelCheck check(context);
    for (std::size_t node = 0; node < boxes_.size(); ++node, check()) build(node);
    sorted_.reserve(edges.size());
    for (const std::uint32_t e : order_) sorted_.push_back(edges[e]);
}

void BorderSearch::build(std::size_t node) {
    std::size_t first = node, last = node;
    while (first < first_leaf_) first = 2 * first + 1, last = 2 * last + 2;
    const auto begin = order_.begin() + std::ptrdiff_t(begin_of_leaf(first - first_leaf_));
    const auto end = order_.begin() + std::ptrdiff_t(begin_of_leaf(last + 1 - first_leaf_));
    Box& box = boxes_[node];
    box = {{infinite, infinite, infinite},
           {-infinite, -infinite, -infinite},
           begin == end ? several : edges_[*begin].mesh};
    for (auto i = begin; i != end; ++i) {
        const BorderEdge& e = edges_[*i];
        box.low = min(box.low, min(e.a, e.b)), box.high = max(box.high, max(e.a, e.b));
        if (e.mesh != box.mesh) box.mesh = several;
    }
    if (node >= first_leaf_) return;
    const dvec3 size = box.high - box.low;
    const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::size_t middle = 2 * node + 2;
    while (middle < first_leaf_) middle = 2 * middle + 1;
    std::nth_element(begin, order_.begin() + std::ptrdiff_t(begin_of_leaf(middle - first_leaf_)), end,
                     [&](std::uint32_t i, std::uint32_t j) {
                         const double a = edges_[i].a[axis] + edges_[i].b[axis],
                                      b = edges_[j].a[axis] + edges_[j].b[axis];
                         return a != b ? a < b : i < j;
                     });
}

bool BorderSearch::may_match(std::uint32_t mesh, std::uint32_t other) const {
    return mesh != other &&
           (options_.scope == Scope::model || input_.meshes[mesh].object == input_.meshes[other].object);
}

/// Conditions that do not depend on the place along the edges.
bool BorderSearch::runs_along(const Question& q, const BorderEdge& other) const {
    if (!may_match(q.own.mesh, other.mesh)) return false;
    const double bend = dot(q.own.face, other.face);
    if (!(bend >= std::max(cosines_[q.own.mesh], cosines_[other.mesh]))) return false;
    if (options_.keep_flat && q.own.is_flat && other.is_flat && bend < cosine_of_flat) return false;
    return dot(q.own.along, other.along) <= cosine_of_opposite;
}

void BorderSearch::test(const Question& q, std::size_t place, BorderHits& out) const {
    const BorderEdge& other = sorted_[place];
    const std::uint32_t number = order_[place];
    if (!runs_along(q, other)) return;
    const double along = dot(q.point - other.a, other.along);
    const double t = std::fmin(1.0, std::fmax(0.0, along / other.length));
    const dvec3 gap = other.point(t) - q.point;
    const double square = dot(gap, gap);
    if (!(square <= q.radius * q.radius)) return;
    const double overlap = std::fmax(dot(gap, q.own.inward), -dot(gap, other.inward));
    if (overlap > overlap_share * q.radius) return;
    const double bias = normal_share * q.radius;
    BorderHit hit{number, other.mesh, t, std::sqrt(square), 0};
    hit.rank = square + bias * bias * (1 - dot(q.normal, other.normal(t)));
    const auto comes_before = [](const BorderHit& a, const BorderHit& b) {
        return a.rank != b.rank ? a.rank < b.rank : a.edge < b.edge;
    };
    const auto begin = out.hits.begin(), end = begin + std::ptrdiff_t(out.count);
    auto at = std::find_if(begin, end, [&](const BorderHit& h) { return h.mesh == hit.mesh; });
    if (at == end && out.count < BorderHits::most)
        ++out.count;
    else if (at == end)
        at = std::max_element(begin, end, comes_before);
    else if (!comes_before(hit, *at))
        return;
    if (at == end || at->mesh == hit.mesh || comes_before(hit, *at)) *at = hit;
}

/// The rank below which the contents of a box could change the hits.
double BorderSearch::limit(const Question& q, const Box& box, const BorderHits& hits) const {
    const double most = q.radius * q.radius;
    if (box.mesh == several) {
        if (hits.count < BorderHits::most) return most;
        double worst = 0;
        for (const BorderHit& h : hits.all()) worst = std::fmax(worst, h.rank);
        return std::fmin(most, worst);
    }
    if (!may_match(q.own.mesh, box.mesh)) return -1;
    for (const BorderHit& h : hits.all())
        if (h.mesh == box.mesh) return std::fmin(most, h.rank);
    return most;
}

void BorderSearch::find(const BorderEdge& own, dvec3 point, dvec3 normal, double radius, BorderHits& out) const {
    out.count = 0, out.gave_up = false;
    const Question q{own, point, normal, radius};
    struct Waiting {
        std::uint32_t node;
        double square;
    };
    std::array<Waiting, 64> stack;  // the tree has at most 32 levels
    std::size_t top = 0;
    std::uint32_t visits = 0;
    const auto push = [&](std::size_t node) {
        const Box& box = boxes_[node];
        const double square = square_distance(point, box.low, box.high);
        if (square <= limit(q, box, out)) stack[top++] = {std::uint32_t(node), square};
    };
    push(0);
    while (top > 0) {
        const Waiting at = stack[--top];
        if (!(at.square <= limit(q, boxes_[at.node], out))) continue;
        if (++visits > max_visits) {
            out.gave_up = true;
            return;
        }
        if (at.node >= first_leaf_) {
            const std::size_t leaf = at.node - first_leaf_;
            for (std::size_t i = begin_of_leaf(leaf); i < begin_of_leaf(leaf + 1); ++i, ++visits) test(q, i, out);
            continue;
        }
        const std::size_t near = top;
        push(2 * std::size_t(at.node) + 2);
        push(2 * std::size_t(at.node) + 1);
        if (top == near + 2 && stack[near].square < stack[near + 1].square) std::swap(stack[near], stack[near + 1]);
    }
}

}  // namespace rakelight::geometry
