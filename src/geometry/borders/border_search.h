// SPDX-License-Identifier: Apache-2.0
// Search for the nearest adjacent open edges of other meshes. Used for matching and for measuring.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/geometry/matching_borders.h>

#include "geometry/borders/border_edges.h"

namespace rakelight::geometry {

/// [distances] Minimum length of a matching stretch: shorter cards and scraps touch anywhere.
constexpr double min_run = 10;

/// A point on an edge of another mesh.
struct BorderHit {
    std::uint32_t edge = 0, mesh = 0;
    double t = 0;         ///< 0..1 from its `a` to its `b`
    double distance = 0;  ///< [m]
    double rank = 0;      ///< smaller means closer in position and normal
};

/// Result of one query: the nearest point of each other mesh, at most four meshes.
struct BorderHits {
    static constexpr std::size_t most = 4;
    std::array<BorderHit, most> hits;
    std::size_t count = 0;
    bool gave_up = false;  ///< the search was cut off; the hits so far are valid
    std::span<const BorderHit> all() const { return {hits.data(), count}; }
};

/// A bounding volume hierarchy over edges (heap order, median split on the widest axis).
class BorderSearch {
public:
    /// @param edges, input  outlive it
    BorderSearch(std::span<const BorderEdge> edges, const AttributeInput& input, const MatchOptions& options,
                 Context& context);

    /// @param own the edge of the query, a part of the surface
    /// @param point   on it
    /// @param normal  there, unit
    /// @param radius [m] replaces MatchOptions::distance
    void find(const BorderEdge& own, dvec3 point, dvec3 normal, double radius, BorderHits& out) const;

    std::span<const BorderEdge> edges() const { return edges_; }

private:
    struct Box {
        dvec3 low, high;
        std::uint32_t mesh;  ///< mesh of all its edges; `several` if there are more than one
    };
    static constexpr std::uint32_t several = 0xffffffffu;
    struct Question;

    void build(std::size_t node);
    void test(const Question& q, std::size_t place, BorderHits& out) const;
    bool runs_along(const Question& q, const BorderEdge& other) const;
    bool may_match(std::uint32_t mesh, std::uint32_t other) const;
    double limit(const Question& q, const Box& box, const BorderHits& hits) const;
    std::size_t begin_of_leaf(std::size_t leaf) const { return (leaf * order_.size()) >> levels_; }

    std::span<const BorderEdge> edges_;
    const AttributeInput& input_;
    const MatchOptions& options_;
    std::vector<double> cosines_;  ///< [meshes] of crease angles
    std::vector<std::uint32_t> order_;
    std::vector<BorderEdge> sorted_;  ///< by `order_`: neighbors are adjacent in memory
    std::size_t levels_ = 0, first_leaf_ = 0;
    std::vector<Box> boxes_;
};

}  // namespace rakelight::geometry
