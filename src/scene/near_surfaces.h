// SPDX-License-Identifier: Apache-2.0
// How near to a camera a scene comes: for near planes that cut nothing off.
#pragma once
#include <functional>
#include <mutex>
#include <span>
#include <vector>

#include <rakelight/scene/scene.h>
#include <rakelight/scene/scene_queries.h>

namespace rakelight {

/// Triangles, lines and points of a scene in runs with boxes, of which a query looks at few.
class NearSurfaces {
public:
    /// @param scene  validated and posed; it must stay as it is. It is read by the first query.
    explicit NearSurfaces(const Scene& scene) : scene_(scene) {}

    /// [m] along the view axis, 0 or more: the nearest point inside the pyramid of a perspective view, `limit` if none is
    /// nearer. Any number of threads may ask at the same time.
    /// @param half  half the width and height of the picture at a distance of 1 m
    double nearest(const dmat4& world_to_camera, dvec2 half, double limit) const;

private:
    /// Box of consecutive primitives of a mesh, in its own space.
    struct Run {
        vec3 low, high;
        bool empty() const { return !(low.x <= high.x); }
    };
    class Search;
    void read() const;

    const Scene& scene_;
    mutable std::once_flag is_read_;
    mutable std::vector<dmat4> world_;            ///< [nodes]
    mutable std::vector<std::vector<Run>> runs_;  ///< [meshes]; the first is the box of all
};

}  // namespace rakelight
