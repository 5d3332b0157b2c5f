// SPDX-License-Identifier: Apache-2.0
// Open edges as the matching of borders sees them: a segment in the world with its face beside it.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/place_classes.h"

namespace rakelight::geometry {

/// The face goes from `a` to `b`, counter-clockwise as seen from outside in the world.
struct BorderEdge {
    dvec3 a, b;                ///< [m] world
    dvec3 along;               ///< unit, a -> b
    dvec3 inward;              ///< unit, in the face's plane, to its inside
    dvec3 face;                ///< the face's normal, unit
    dvec3 normal_a, normal_b;  ///< of the mesh, unit
    double length = 0;         ///< [m]
    std::uint32_t mesh = 0;
    std::uint32_t vertex_a = 0, vertex_b = 0;  ///< numbered through
    bool is_flat = false;                      ///< authored_flat_deg
    dvec3 point(double t) const { return a + (b - a) * t; }
    /// Interpolated, unit; zero where both ends cancel.
    dvec3 normal(double t) const { return normalize_or(normal_a * (1 - t) + normal_b * t, dvec3{}); }
};

/// In the order of the open corners. Edges are left out that have no length, whose face has no area or one of whose
/// ends has no usable normal.
/// @throws Error bad_file: over the memory budget
std::vector<BorderEdge> border_edges(const PlacedMeshes& placed, std::span<const std::uint32_t> open_corners,
                                     Context& context);

}  // namespace rakelight::geometry
