// SPDX-License-Identifier: Apache-2.0
// The side of a triangle on which its vertex normals lie, if neither winding nor normals are reliable alone.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/geometry/attributes.h>

namespace rakelight::geometry {

/// Orientation of a mesh's normals relative to the winding of its triangles.
struct NormalSides {
    bool all_against = false;           ///< for all triangles; ignored if `against` is given
    std::vector<std::int32_t> against;  ///< [T] 1: on the side from which the corners are clockwise, else 0; or empty
    bool is_against(std::size_t triangle) const { return against.empty() ? all_against : against[triangle] != 0; }
    bool operator==(const NormalSides&) const = default;
};

/// Files have wrong winding with correct normals, and normals averaged around a fold point away from correctly wound
/// triangles. So the side is decided per piece of smooth surface: triangles of any meshes that share edges with one
/// normal at each end, used once in each direction. The winding is consistent within a piece. Normals oppose it if the
/// sum over the piece of weight times cosine (of corner and triangle normal) is negative for every CornerWeight. For
/// normals that are sums of the piece's triangles by one of these weights, that sum equals the sum of the lengths
/// before normalization, and so is positive.
/// @param meshes  with normals, of any length; indices in range. The arrays outlive the call
/// @return [meshes] equal for any number of threads. Expected O(n); little more than one pass if no normals oppose
///         their triangle.
/// @throws Error bad_file: as compute_attributes(), or over the memory budget; failed: cancelled
std::vector<NormalSides> find_normal_sides(std::span<const AttributeMesh> meshes, Context& context);

}  // namespace rakelight::geometry
