// SPDX-License-Identifier: Apache-2.0
// join_seams() on the shapes of tests.
#pragma once
#include <cmath>
#include <vector>

#include <rakelight/geometry/seams.h>

#include "unit/geometry/shapes.h"

namespace rakelight::test {

struct Joined {
    std::vector<MeshSeams> meshes;
    SeamReport report;
};

inline Joined join(const std::vector<Shape>& shapes, double crease_deg = 60, int threads = 2) {
    Context context({.threads = threads});
    Joined out;
    out.meshes = join_seams(views(shapes), {.crease_angle_rad = crease_deg == 180 ? pi : radians(crease_deg)},
                            out.report, context);
    return out;
}

/// The shapes with the turned normals in their places.
inline std::vector<Shape> applied(std::vector<Shape> shapes, const Joined& joined) {
    for (std::size_t m = 0; m < shapes.size(); ++m)
        for (std::size_t i = 0; i < joined.meshes[m].vertices.size(); ++i)
            shapes[m].normals[joined.meshes[m].vertices[i]] = joined.meshes[m].normals[i];
    return shapes;
}

inline double degrees_between(dvec3 a, dvec3 b) { return degrees(std::atan2(length(cross(a, b)), dot(a, b))); }
inline double degrees_between(vec3 a, vec3 b) { return degrees_between(cast<double>(a), cast<double>(b)); }

}  // namespace rakelight::test
