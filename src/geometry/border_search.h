// SPDX-License-Identifier: Apache-2.0
// The nearest open edges of other meshes that run along an edge: which ones do is decided here, for matching and for measuring.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/matching_borders.h>

#include "geometry/border_edges.h"

namespace rakelight::geometry {

/// How long borders have to run along each other to match [distances]: cards and scraps that are shorter meet anywhere.
constexpr double min_run = 10;

/// A point on an edge of another mesh.
struct BorderHit {
    std::uint32_t edge = 0, mesh = 0;
    double t = 0;         ///< 0..1 from its `a` to its `b`
    double distance = 0;  ///< [m]
    double rank = 0;      ///< the smaller, the nearer in place and normal
};

/// What one question finds: of each other mesh the nearest point; of more than four meshes the nearest four.
struct BorderHits {
    static constexpr std::size_t most = 4;
    std::array<BorderHit, most> hits;
    std::size_t count = 0;
    bool gave_up = false;  ///< the work was too much; the hits so far stand
    std::span<const BorderHit> all() const { return {hits.data(), count}; }
};

/// A tree of boxes (heap order, cut in the middle of the widest axis) over edges.
class BorderSearch {
public:
    /// @param edges, input  outlive it
    BorderSearch(std::span<const BorderEdge> edges, const AttributeInput& input, const MatchOptions& options,
                 Context& context);

    /// @param own     the edge from which is asked, a part of the surface
    /// @param point   on it
    /// @param normal  there, unit
    /// @param radius  [m] in place of MatchOptions::distance
    void find(const BorderEdge& own, dvec3 point, dvec3 normal, double radius, BorderHits& out) const;

    std::span<const BorderEdge> edges() const { return edges_; }

private:
    struct Box {
        dvec3 low, high;
        std::uint32_t mesh;  ///< of all its edges; `several` where they are of more than one
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
    std::vector<BorderEdge> sorted_;  ///< by `order_`: neighbors lie together in memory
    std::size_t levels_ = 0, first_leaf_ = 0;
    std::vector<Box> boxes_;
};

}  // namespace rakelight::geometry
