// SPDX-License-Identifier: Apache-2.0
// The side of a triangle on which its vertex normals lie, if neither winding nor normals are reliable alone.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/attributes.h>

namespace rakelight::geometry {

/// Orientation of a mesh's normals relative to the winding of its triangles.
struct NormalSides {
    bool all_against = false;           ///< of all triangles; not looked at where `against` is there
    std::vector<std::int32_t> against;  ///< [T] 1: on the side from which the corners turn clockwise, else 0; or empty
    bool is_against(std::size_t triangle) const { return against.empty() ? all_against : against[triangle] != 0; }
    bool operator==(const NormalSides&) const = default;
};

/// Files wind triangles wrongly whose normals are right; and normals that are averaged around a fold stand away from
/// triangles that are wound rightly. So the side is not asked of each triangle but of each piece of smooth surface:
/// triangles that meet along edges whose ends have one normal each, run through once in either direction, in whichever
/// meshes. Inside a piece the winding is one and counts. The normals stand against it where the sum over the piece of
/// weight times cosine (of corner normal and triangle normal) is negative by every weight of CornerWeight: of normals
/// that are sums of the piece's own triangles by one of these weights that sum is the sum of their lengths before they
/// were made unit, and so positive.
/// @param meshes  with normals, of any length; indices in range. The arrays outlive the call
/// @return [meshes] the same for any number of threads. Expected O(n); little more than one pass where no triangle's
///         own normals are against it.
/// @throws Error bad_file: sizes or matrices as compute_attributes() says, or more memory than allowed; failed:
/// cancelled
std::vector<NormalSides> find_normal_sides(std::span<const AttributeMesh> meshes, Context& context);

}  // namespace rakelight::geometry
