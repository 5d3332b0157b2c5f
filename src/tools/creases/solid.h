// SPDX-License-Identifier: Apache-2.0
// Closed solids as polygons that know their surface: two polygons of different surfaces meet in an edge that is meant
// hard.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "tools/creases/path.h"

namespace rakelight {

using Loop = std::vector<dvec3>;
using Surface = std::uint32_t;

/// Polygons are convex and counter-clockwise seen from outside. What a call adds gets new surface numbers.
class Solid {
public:
    struct Polygon {
        Loop points;
        Surface surface = 0;
    };

    Surface new_surface() { return surfaces_++; }
    /// One for each side, equal where the labels are.
    std::vector<Surface> new_surfaces(std::span<const int> labels);
    void add(Loop points, Surface surface) { polygons_.push_back({std::move(points), surface}); }
    void add(const Solid& other, const std::function<dvec3(dvec3)>& moved = {});
    /// Triangles around the middle of the loop.
    void add_fan(const Loop& loop, Surface surface);
    /// A flat polygon of any form; holes run as the loop does.
    void add_flat(const Loop& loop, const std::vector<Loop>& holes, Surface surface);
    /// Squares between two loops, `high` above `low`. As many sides as points: closed.
    void add_band(const Loop& low, const Loop& high, std::span<const Surface> sides);
    void add_band(const Loop& low, const Loop& high, Surface surface);  ///< closed
    /// Bands of one surface for each label between loops one after the other. Without ends.
    void add_loft(const std::vector<Loop>& sections, std::span<const int> labels, bool is_ring = false);
    /// From z0 to z1 along z, with flat ends.
    void add_extruded(const Path& outline, double z0, double z1, const std::vector<Path>& holes = {});
    /// Walls only. Outwards: as seen from inside of the outline's surroundings, for holes.
    void add_walls(const Path& outline, double z0, double z1, bool outwards = true);
    /// A profile in (radius, z) around the z axis: from the bottom of the axis up, or closed, counter-clockwise.
    /// @param turns  directions of the points [turns], ascending in 0..1
    void add_revolved(const Path& profile, std::span<const double> turns);
    void add_revolved(const Path& profile, int sides, double first_turn = 0);

    /// Cuts everything off whose (p - point) has a positive product with `normal`. The end is a fan around `point`.
    void cut(dvec3 point, dvec3 normal);
    /// Makes the edge between two points hard, though it lies within one surface.
    void crease(dvec3 a, dvec3 b) { creases_.emplace_back(a, b); }
    void move(const std::function<dvec3(dvec3)>& moved);
    /// Turns about x, then y, then z.
    void turn(double x_deg, double y_deg, double z_deg);
    void flip();  ///< inside out

    const std::vector<Polygon>& polygons() const { return polygons_; }
    const std::vector<std::pair<dvec3, dvec3>>& creases() const { return creases_; }

private:
    std::vector<Polygon> polygons_;
    std::vector<std::pair<dvec3, dvec3>> creases_;
    Surface surfaces_ = 0;
};

/// [turns] `sides` equal steps.
std::vector<double> even_turns(int sides, double first_turn = 0);
Loop ring(double radius, double z, int sides, double first_turn = 0);
Loop reversed(Loop loop);
Loop at_height(const std::vector<dvec2>& points, double z);
/// The point moved to a cylinder's coordinates.
dvec3 around(double radius, double turn, double z);
std::function<dvec3(dvec3)> shift(double x, double y, double z);
std::function<dvec3(dvec3)> turned(double x_deg, double y_deg, double z_deg);

}  // namespace rakelight
