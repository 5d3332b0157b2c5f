// SPDX-License-Identifier: Apache-2.0
// Open edges for border matching: a segment in world space with its face.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/faults/place_classes.h"

namespace rakelight::geometry {

/// Directed from `a` to `b` in the counter-clockwise winding of the face, seen from outside in world space.
struct BorderEdge {
    dvec3 a, b;                ///< [m] world
    dvec3 along;               ///< unit, a -> b
    dvec3 inward;              ///< unit, in the face's plane, toward its interior
    dvec3 face;                ///< the face's normal, unit
    dvec3 normal_a, normal_b;  ///< of the mesh, unit
    double length = 0;         ///< [m]
    std::uint32_t mesh = 0;
    std::uint32_t vertex_a = 0, vertex_b = 0;  ///< global indices
    bool is_flat = false;                      ///< authored_flat_deg
    dvec3 point(double t) const { return a + (b - a) * t; }
    /// Interpolated, unit; zero if both ends cancel.
    dvec3 normal(double t) const { return normalize_or(normal_a * (1 - t) + normal_b * t, dvec3{}); }
};

/// Whether so many open edges can be matched.
/// @throws Error bad_file: over the memory budget
void check_matching_memory(std::size_t open_edges, Context& context);

/// In the order of the open corners. Skips edges without length, edges of faces without area, and edges with an
/// unusable normal at an end.
/// @throws Error bad_file: over the memory budget
std::vector<BorderEdge> border_edges(const PlacedMeshes& placed, std::span<const std::uint32_t> open_corners,
                                     Context& context);

}  // namespace rakelight::geometry
