// SPDX-License-Identifier: Apache-2.0
// Where rays hit surfaces that are given by their formulas, in double.
#pragma once
#include <array>

#include <rakelight/scene/scene.h>
#include <rakelight/scene/scene_queries.h>

namespace rakelight::raytrace {

struct ShapeHit {
    double t = 0;
    std::uint32_t face = 0;  ///< ShapeFaceNumber
};

struct ShapeHits {
    std::array<ShapeHit, 4> at{};
    int count = 0;
};

/// All of them, nearest first, also behind the origin. Of a direction of length 0: none.
ShapeHits meet(const ExactShape& shape, dvec3 origin, dvec3 direction);

/// Outward normal at a place on it, of any length.
dvec3 outward(const ExactShape& shape, std::uint32_t face, dvec3 place);

Bounds bounds_of(const ExactShape& shape);

}  // namespace rakelight::raytrace
