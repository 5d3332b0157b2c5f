// SPDX-License-Identifier: Apache-2.0
// Where elements are to be cut finer: at the borders of shadows, where neighbors receive different light.
#pragma once
#include "radiosity/elements.h"

namespace rakelight::radiosity {

/// Edges by their two places, to be asked for.
class EdgeSet {
public:
    void add(dvec3 a, dvec3 b);
    void finish();  ///< before the first question
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

/// The edges of elements whose light differs from that of a neighbor's by more than a share of their mean, those of the
/// greatest difference times area first, as many as leave the elements within `most`.
/// @param light    [elements] irradiance / pi
/// @param floor    luminance below which differences are not seen
EdgeSet shadow_borders(const std::vector<Part>& parts, const std::vector<geometry::FineMesh>& meshes,
                       const Elements& elements, const std::vector<dvec3>& light, double floor, std::uint64_t most);

}  // namespace rakelight::radiosity
