// SPDX-License-Identifier: Apache-2.0
// A triangle mesh whose hard edges are known, because it was made of surfaces.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/creases/solid.h"

namespace rakelight {

/// How squares are cut: from the first corner, from the second, by turns, or by either at random.
enum class Diagonals { first, second, alternating, random };

/// How a solid becomes a mesh.
struct Making {
    int digits = 6;  ///< of decimals that positions are rounded to
    int bits = 0;    ///< > 0: positions are whole steps of 2^-bits of the largest extent instead
    Diagonals diagonals = Diagonals::first;
    /// Whether the shape says which edges are hard. Columns of few equal sides and rocks do not.
    bool is_decidable = true;
};

struct CreaseModel {
    std::string name;
    bool is_holdout = false, is_decidable = true;
    std::vector<dvec3> positions, exact;  ///< [V] welded after rounding; before rounding
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Surface> surfaces;       ///< [T]
    std::vector<std::uint8_t> hard;      ///< [T] bit k: the edge from corner k to the next is meant hard
    std::vector<std::uint32_t> objects;  ///< [T] 0 and up, all in use
    double step = 0;                     ///< that positions were rounded to
    bool is_quantized = false;           ///< to steps of a grid, not to decimals
};

/// Welds positions that are equal after rounding and leaves faces out that lost a corner by it.
CreaseModel make_model(std::string name, const Solid& solid, const Making& making = {});
/// @param object_of  by the middle of a triangle, and its surface
void cut_into_objects(CreaseModel& model, const std::function<std::uint32_t(dvec3 middle, Surface surface)>& object_of);

/// An edge of two triangles.
struct ModelEdge {
    std::array<std::uint32_t, 2> triangles, corners;  ///< it begins at this corner of each
    double length = 0;
    double bend_deg = 0;  ///< between the normals before rounding; negative where the surface is hollow
    bool is_hard = false;
};
/// All edges of two triangles, in the order of their first triangle.
std::vector<ModelEdge> edges_of(const CreaseModel& model);

}  // namespace rakelight
