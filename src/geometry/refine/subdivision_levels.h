// SPDX-License-Identifier: Apache-2.0
// The refinement levels of a control surface with their sharpness. Only this header and its includers name OpenSubdiv:
// Far::TopologyRefiner for the topology, nothing of its evaluation.
#pragma once
#include <opensubdiv/far/topologyRefiner.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/refine/subdivide.h"

namespace rakelight::geometry {

using Level = OpenSubdiv::Far::TopologyLevel;

inline constexpr float sharp_forever = 10;  ///< Sdc::Crease::SHARPNESS_INFINITE

/// Calls body(i) for 0..count-1 on any number of threads.
template <class Body>
void for_all(int count, Context& context, const Body& body) {
    constexpr int run = 4096;
    context.parallel_for(std::size_t(count + run - 1) / run, [&](std::size_t chunk) {
        const int first = int(chunk) * run, end = std::min(count, first + run);
        for (int i = first; i < end; ++i) body(i);
    });
}
struct Sharpness {
    std::vector<int> edges, vertices;
    std::vector<float> of_edges, of_vertices;

    void add_edge(std::uint32_t a, std::uint32_t b, double sharpness) {
        edges.insert(edges.end(), {int(a), int(b)});
        of_edges.push_back(float(std::min(sharpness, double(sharp_forever))));
    }
    void add_vertex(std::uint32_t v) {
        vertices.push_back(int(v));
        of_vertices.push_back(sharp_forever);
    }
};

/// @param corners  [corners of the faces] < count
/// @throws Error bad_file: too many faces at a vertex or edge
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> refine(const ControlSurface& surface,
                                                         const std::vector<std::uint32_t>& corners, std::size_t count,
                                                         const Sharpness& sharpness);

enum class Rule : std::uint8_t { smooth, crease, corner };

/// How sharp it is at a vertex, now or a level later.
struct Corner {
    Rule rule;
    int ends[2];  ///< crease: the far ends of its edges
};

int far_end(const Level& level, int edge, int vertex);

/// One sharp edge ends in a dart, which moves as a smooth vertex; DeRose et al. 1998, section 3.
Corner corner_at(const Level& level, int vertex, bool is_later);

/// The part that the rule before has where sharpness ends within a level; DeRose et al. 1998, appendix B.
double part_of_sharp_rule(const Level& level, int vertex);

}  // namespace rakelight::geometry
