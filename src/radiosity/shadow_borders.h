// SPDX-License-Identifier: Apache-2.0
// Adaptive subdivision at shadow boundaries, where neighboring elements differ in light.
#pragma once
#include "radiosity/elements.h"

namespace rakelight::radiosity {

/// A set of edges, identified by their two places.
class EdgeSet {
public:
    void add(dvec3 a, dvec3 b);
    void finish();  ///< before the first query
    bool holds(dvec3 a, dvec3 b) const;
    bool empty() const { return edges_.empty(); }

private:
    struct Edge {
        dvec3 a, b;
    };
    static Edge in_order(dvec3 a, dvec3 b);
    static bool is_less(const Edge& x, const Edge& y);
    std::vector<Edge> edges_;
};

/// The edges of elements whose light differs from a neighbor's by more than a share of their mean. Edges with the
/// largest difference times area are first, limited to `most` elements.
/// @param light    [elements] irradiance / pi
/// @param floor luminance below which differences are ignored
EdgeSet shadow_borders(const std::vector<Part>& parts, const std::vector<geometry::FineMesh>& meshes,
                       const Elements& elements, const std::vector<dvec3>& light, double floor, std::uint64_t most);

}  // namespace rakelight::radiosity
