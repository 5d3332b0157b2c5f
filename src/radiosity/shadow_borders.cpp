// SPDX-License-Identifier: Apache-2.0
#include "radiosity/shadow_borders.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "math/linear.h"
#include "shading/lights/luminance.h"

namespace rakelight::radiosity {
namespace {

constexpr double min_difference = 0.06;  ///< of the mean of two neighbors
constexpr double min_cosine = 0.7;       ///< of the normals of elements whose light is compared

auto tied(dvec3 p) { return std::tuple(p.x, p.y, p.z); }

/// One side of an element's edge.
struct Side {
    dvec3 a, b;
    std::uint32_t element;
};

std::vector<Side> sorted_sides(const Elements& elements) {
    std::vector<Side> sides;
    sides.reserve(3 * elements.size());
    for (std::uint32_t i = 0; i < elements.size(); ++i)
        for (std::size_t k = 0; k < 3 && elements.list[i].area > 0; ++k) {
            dvec3 a = elements.list[i].corner[k], b = elements.list[i].corner[(k + 1) % 3];
            if (tied(b) < tied(a)) std::swap(a, b);
            sides.push_back({a, b, i});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
        return std::tuple(tied(x.a), tied(x.b), x.element) < std::tuple(tied(y.a), tied(y.b), y.element);
    });
    return sides;
}

/// [elements] difference from the neighbors as a share of the mean.
std::vector<double> differences(const Elements& elements, const std::vector<dvec3>& light, double floor) {
    std::vector<double> out(elements.size(), 0);
    const std::vector<Side> sides = sorted_sides(elements);
    const auto compare = [&](std::uint32_t i, std::uint32_t j) {
        const Element &a = elements.list[i], &b = elements.list[j];
        if (dot(a.normal, b.normal) < min_cosine) return;
        const double x = shading::luminance_of(light[i]), y = shading::luminance_of(light[j]);
        const double difference = std::fabs(x - y) / (0.5 * (x + y) + floor);
        out[i] = std::max(out[i], difference), out[j] = std::max(out[j], difference);
    };
    for (std::size_t first = 0; first < sides.size();) {
        std::size_t end = first + 1;
        while (end < sides.size() && sides[end].a == sides[first].a && sides[end].b == sides[first].b) ++end;
        for (std::size_t i = first; i < std::min(end, first + 8); ++i)
            for (std::size_t j = i + 1; j < std::min(end, first + 8); ++j) compare(sides[i].element, sides[j].element);
        first = end;
    }
    return out;
}

/// Number of elements after bisecting the edges.
std::uint64_t count_after(const std::vector<Part>& parts, const std::vector<geometry::FineMesh>& meshes,
                          const EdgeSet& edges) {
    std::uint64_t count = count_sides(parts, meshes);
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const geometry::FineMesh& mesh = meshes[m];
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
            for (std::size_t k = 0; k < 3; ++k)
                if (edges.holds(mesh.places[mesh.indices[i + k]], mesh.places[mesh.indices[i + (k + 1) % 3]]))
                    count += parts[m].sides();
    }
    return count;
}

EdgeSet edges_of(const Elements& elements, std::span<const std::uint32_t> chosen) {
    EdgeSet out;
    for (const std::uint32_t i : chosen)
        for (std::size_t k = 0; k < 3; ++k) out.add(elements.list[i].corner[k], elements.list[i].corner[(k + 1) % 3]);
    out.finish();
    return out;
}

}  // namespace

EdgeSet::Edge EdgeSet::in_order(dvec3 a, dvec3 b) { return tied(b) < tied(a) ? Edge{b, a} : Edge{a, b}; }
bool EdgeSet::is_less(const Edge& x, const Edge& y) {
    return std::tuple(tied(x.a), tied(x.b)) < std::tuple(tied(y.a), tied(y.b));
}
void EdgeSet::add(dvec3 a, dvec3 b) { edges_.push_back(in_order(a, b)); }
void EdgeSet::finish() {
    std::sort(edges_.begin(), edges_.end(), is_less);
    edges_.erase(std::unique(edges_.begin(), edges_.end(),
                             [](const Edge& x, const Edge& y) { return x.a == y.a && x.b == y.b; }),
                 edges_.end());
}
bool EdgeSet::holds(dvec3 a, dvec3 b) const {
    return std::binary_search(edges_.begin(), edges_.end(), in_order(a, b), is_less);
}

EdgeSet shadow_borders(const std::vector<Part>& parts, const std::vector<geometry::FineMesh>& meshes,
                       const Elements& elements, const std::vector<dvec3>& light, double floor, std::uint64_t most) {
    const std::vector<double> difference = differences(elements, light, floor);
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t i = 0; i < difference.size(); ++i)
        if (difference[i] > min_difference) chosen.push_back(i);
    // Ordered by the error in a picture: difference times area.
    const auto error = [&](std::uint32_t i) { return difference[i] * elements.list[i].area; };
    std::sort(chosen.begin(), chosen.end(), [&](std::uint32_t a, std::uint32_t b) {
        const double x = error(a), y = error(b);
        return x != y ? x > y : a < b;
    });
    std::size_t low = 0, high = chosen.size();  // the most that fit
    while (low < high) {
        const std::size_t middle = (low + high + 1) / 2;
        const EdgeSet edges = edges_of(elements, std::span(chosen).first(middle));
        if (count_after(parts, meshes, edges) <= most)
            low = middle;
        else
            high = middle - 1;
    }
    return edges_of(elements, std::span(chosen).first(low));
}

}  // namespace rakelight::radiosity
