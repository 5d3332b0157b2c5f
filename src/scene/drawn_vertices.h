// SPDX-License-Identifier: Apache-2.0
// The vertices that a scene draws, in runs with bounding boxes, so that queries look at few of them.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/scene/scene.h>
#include <rakelight/scene/scene_queries.h>

namespace rakelight {

/// Box and support distances of a scene. What no triangle, line or point uses, and what is not finite, does not count.
/// Results are those of a walk over all vertices, to the bit: rounding is monotonic, so no vertex of a run lies farther
/// along a direction than the corner of its box. Queries are fast where near vertices follow one another, as in most
/// files; of shuffled ones they look at all.
class DrawnVertices {
public:
    /// @param scene  validated; the queries read it, so it must stay as it is
    explicit DrawnVertices(const Scene& scene);

    /// Axis-aligned box in world space; empty if nothing is drawn.
    const Bounds& bounds() const { return bounds_; }
    /// Support distances: for each direction (any length) the maximum of dot(direction, vertex - about) over all
    /// vertices in world space. 0 if nothing is drawn.
    void farthest_along(dvec3 about, std::span<const dvec3> directions, std::span<double> reach) const;

private:
    /// 64 consecutive vertices of a mesh.
    struct Run {
        vec3 low, high;          ///< box of those that are used
        std::uint64_t used = 0;  ///< a bit each
    };
    class Search;
    void add(std::uint32_t mesh);
    std::span<const Run> runs_of(std::uint32_t mesh) const;
    void extend_bounds(std::uint32_t mesh, const dmat4& to_world);

    const Scene& scene_;
    std::vector<dmat4> world_;            ///< [nodes]
    std::vector<std::size_t> first_run_;  ///< [meshes]; no_runs: no node draws the mesh
    std::vector<Run> runs_;               ///< mesh after mesh
    Bounds bounds_;
};

/// Axis-aligned box in world space of all drawn vertices of all objects, without non-finite ones. Empty if nothing is
/// drawn.
Bounds world_bounds(const Scene& scene);

}  // namespace rakelight
