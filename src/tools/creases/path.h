// SPDX-License-Identifier: Apache-2.0
// Polylines in the plane whose sides carry labels, and the triangles of flat polygons with holes.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <rakelight/math/vector.h>

namespace rakelight {

/// Sides with equal labels belong to one surface, so edges between them are meant soft. Side i leads from point i to the
/// next one; a closed path has as many sides as points.
class Path {
public:
    Path(double x, double y) : points_{{x, y}} {}
    explicit Path(dvec2 start) : points_{start} {}
    Path& to(dvec2 point, int label);  ///< nothing where it is the last point already
    Path& to(double x, double y, int label) { return to(dvec2{x, y}, label); }
    /// Goes on from the last point, which should be at `from_deg`.
    Path& arc(dvec2 center, double radius, double from_deg, double to_deg, int steps, int label);
    Path& close(int label);
    bool is_closed() const { return labels_.size() == points_.size(); }
    const std::vector<dvec2>& points() const { return points_; }
    const std::vector<int>& labels() const { return labels_; }

private:
    std::vector<dvec2> points_;
    std::vector<int> labels_;
};

dvec2 polar(dvec2 center, double radius, double deg);
/// Counter-clockwise, one label for all sides.
Path circle(dvec2 center, double radius, int steps, int label, double first_deg = 0);
/// Counter-clockwise, each side with its own label.
Path polygon(const std::vector<dvec2>& points);
Path regular(int sides, double radius, double first_deg = 0, dvec2 center = {});
Path rectangle(double x0, double y0, double x1, double y1);
/// A rectangle around the origin whose corners are arcs of `steps` sides. All sides have one label where the corners are
/// soft, else each side and each corner has its own.
Path rounded_rectangle(double half_x, double half_y, double radius, int steps, bool soft);

/// Triangles of a polygon with holes, as indices into the points of `outer` and then of the holes. All loops are
/// counter-clockwise. Ears are cut in the order of their smallest angle, the largest first.
std::vector<std::array<std::uint32_t, 3>> triangulated(const std::vector<dvec2>& outer,
                                                       const std::vector<std::vector<dvec2>>& holes);

}  // namespace rakelight
