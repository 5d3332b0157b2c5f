// SPDX-License-Identifier: Apache-2.0
// Automatic creases: edges that are hard or soft by construction.
#include <rakelight/geometry/creases.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>

#include "unit/geometry/creases/hard_shapes.h"

namespace rakelight::test {
namespace {

Creases creases_of(const std::vector<Shape>& shapes, int threads = 2) {
    Context context({.threads = threads});
    return find_creases(views(shapes), {}, context);
}

using Point = std::tuple<float, float, float>;
using Edge = std::pair<Point, Point>;

/// The hard edges as pairs of points, whatever their numbers.
std::set<Edge> hard_edges(const std::vector<Shape>& shapes, const Creases& creases) {
    std::set<Edge> out;
    for (std::size_t m = 0; m < shapes.size(); ++m)
        for (std::size_t c = 0; c < shapes[m].indices.size(); ++c) {
            if ((creases.hard[m][c / 3] >> c % 3 & 1) == 0) continue;
            const vec3 a = shapes[m].positions[shapes[m].indices[c]],
                       b = shapes[m].positions[shapes[m].indices[c - c % 3 + (c + 1) % 3]];
            const Point p{a.x, a.y, a.z}, q{b.x, b.y, b.z};
            out.insert(std::minmax(p, q));
        }
    return out;
}
std::set<Edge> hard_edges(const std::vector<Shape>& shapes) { return hard_edges(shapes, creases_of(shapes)); }

/// Edges between different surfaces.
std::set<Edge> meant_hard(const HardShape& made) {
    std::map<Edge, std::set<int>> surfaces;
    const Shape& s = made.shape;
    for (std::size_t c = 0; c < s.indices.size(); ++c) {
        const vec3 a = s.positions[s.indices[c]], b = s.positions[s.indices[c - c % 3 + (c + 1) % 3]];
        surfaces[std::minmax(Point{a.x, a.y, a.z}, Point{b.x, b.y, b.z})].insert(made.surface[c / 3]);
    }
    std::set<Edge> out;
    for (const auto& [edge, of] : surfaces)
        if (of.size() > 1) out.insert(edge);
    return out;
}

void expect_as_meant(const HardShape& made, const char* what) {
    EXPECT_EQ(hard_edges({made.shape}), meant_hard(made)) << what;
}

TEST(CreaseEdges, AHexagonalNutIsTheSameForEveryRounding) {
    for (const double step : {0.0, 1e-6, 1e-4, 1e-3, 1e-2})
        for (const double turn : {0.0, 0.1, 0.4}) expect_as_meant(make_nut(step, turn), "nut");
}

TEST(CreaseEdges, AQuantizedNutIsDecidedByItsStep) {
    for (const double turn : {0.0, 0.1, 0.4}) {
        HardShape nut = make_nut(2.0 / 16384, turn);
        AttributeMesh mesh = nut.shape.view();
        mesh.position_step = 2.0 / 16384;
        Context context;
        const Creases creases = find_creases(std::span(&mesh, 1), {}, context);
        EXPECT_EQ(hard_edges({nut.shape}, creases), meant_hard(nut));
        EXPECT_EQ(creases.report.rings[6], 1u);
    }
}

TEST(CreaseEdges, ChamfersAreHardAndFilletsAreSoft) {
    for (const double chamfer : {0.05, 0.15, 0.3}) expect_as_meant(make_chamfered_box(chamfer), "chamfer");
    for (const int strips : {2, 3, 4, 8}) expect_as_meant(make_fillets(strips, 0.2), "fillet");
    expect_as_meant(make_fillets(5, 0.6), "large fillet");
    expect_as_meant(make_fillets(4, 0.2, 1e-3), "rounded fillet");
}

/// A box of size 2 whose edges are rounded in strips, and whose corners are parts of spheres.
HardShape make_rounded_box(int strips, double radius) {
    HardBuilder b;
    const int n = 4 * strips + 4;  // columns: each quarter has strips + 1
    const auto point = [&](int column, int row) {
        const int quarter = (column / (strips + 1)) % 4, i = column % (strips + 1);
        const bool upper = row > strips;
        const double a = pi / 2 * (quarter + double(i) / strips),
                     e = pi / 2 * (double(upper ? row - 1 : row) / strips - 1), c = 1 - radius;
        const double x = quarter == 0 || quarter == 3 ? c : -c, y = quarter < 2 ? c : -c;
        return dvec3{x + radius * std::cos(e) * std::cos(a), y + radius * std::cos(e) * std::sin(a),
                     (upper ? c : -c) + radius * std::sin(e)};
    };
    const int rows = 2 * strips + 1;
    for (int r = 0; r < rows; ++r)
        for (int k = 0; k < n; ++k)
            b.polygon({point(k, r), point((k + 1) % n, r), point((k + 1) % n, r + 1), point(k, r + 1)}, 0);
    const auto lid = [&](int row, bool up) {
        std::vector<dvec3> ring;
        for (int q = 0; q < 4; ++q) ring.push_back(point(q * (strips + 1), row));
        b.polygon(up ? ring : std::vector<dvec3>(ring.rbegin(), ring.rend()), 0);
    };
    lid(0, false), lid(rows, true);
    return b.take();
}

TEST(CreaseEdges, RoundedCornersAreSoft) {
    for (const int strips : {3, 4, 8}) {
        const HardShape box = make_rounded_box(strips, 0.2);
        EXPECT_TRUE(hard_edges({box.shape}).empty()) << strips << ": " << hard_edges({box.shape}).size();
    }
}

TEST(CreaseEdges, GearsAreHard) {
    for (const double step : {0.0, 1e-3, 1e-2}) expect_as_meant(make_gear(step), "gear");
}

TEST(CreaseEdges, ColumnsAreFlatUpToSevenSides) {
    for (const int sides : {3, 4, 5, 6, 7}) expect_as_meant(make_column(sides, true), "prism");
    for (const int sides : {8, 9, 12, 16, 24, 48}) {
        expect_as_meant(make_column(sides, false), "column");
        expect_as_meant(make_column(sides, false, 1e-3, 0.1), "rounded column");
    }
    EXPECT_EQ(creases_of({make_column(6, true).shape}).report.rings[6], 1u);
    EXPECT_EQ(creases_of({make_column(8, false).shape}).report.rings[8], 1u);
    EXPECT_EQ(creases_of({make_column(24, false).shape}).report.rings, CreaseReport{}.rings);
}

TEST(CreaseEdges, SmoothSurfacesHaveNone) {
    EXPECT_TRUE(hard_edges({make_sphere(12, 8)}).empty());
    EXPECT_TRUE(hard_edges({make_torus(24, 12)}).empty());
    EXPECT_TRUE(hard_edges({make_cylinder(12, 1)}).empty());
}

/// A surface of squares: a cube whose sides are divided, drawn onto a lump.
HardShape make_lump(int cells, double height, dvec3 axes, double step) {
    HardBuilder b(step);
    const auto point = [&](int axis, int sign, int i, int j) {
        double p[3];
        p[axis] = sign, p[(axis + 1) % 3] = 2.0 * i / cells - 1, p[(axis + 2) % 3] = 2.0 * j / cells - 1;
        const dvec3 n = normalize_or(dvec3{p[0], p[1], p[2]}, dvec3{});
        const double bump = std::sin(4 * n.x + 1) * std::sin(4 * n.y + 2) * std::sin(4 * n.z + 0.5);
        const dvec3 at = n * (1 + height * bump);
        return dvec3{axes.x * at.x, axes.y * at.y, axes.z * at.z};
    };
    for (const int axis : {0, 1, 2})
        for (const int sign : {-1, 1})
            for (int i = 0; i < cells; ++i)
                for (int j = 0; j < cells; ++j) {
                    std::vector<dvec3> square{point(axis, sign, i, j), point(axis, sign, i + 1, j),
                                              point(axis, sign, i + 1, j + 1), point(axis, sign, i, j + 1)};
                    if (sign < 0) std::reverse(square.begin(), square.end());
                    std::rotate(square.begin(), square.begin() + (i + j) % 2, square.end());  // both diagonals
                    b.polygon(square, 0);
                }
    return b.take();
}

/// A surface of revolution. @param profile  [points] radius and height from below, first and last on the axis or a lid
HardShape make_turned(const std::vector<dvec2>& profile, const std::vector<int>& ids, int sides, double step = 0) {
    HardBuilder b(step, 0.1);
    for (std::size_t i = 0; i + 1 < profile.size(); ++i)
        b.wall(circle(sides, profile[i].x, profile[i].y), circle(sides, profile[i + 1].x, profile[i + 1].y), ids[i]);
    if (profile.front().x > 0) b.cap(circle(sides, profile.front().x, profile.front().y), 1000, false);
    if (profile.back().x > 0) b.cap(circle(sides, profile.back().x, profile.back().y), 1001, true);
    return b.take();
}

TEST(CreaseEdges, SquaresOfALumpAreSoftForEveryRounding) {
    // To a hundredth of its size, faces are turned so far that nothing is known of their planes.
    for (const double step : {0.0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2})
        for (const int cells : {6, 12})
            EXPECT_TRUE(hard_edges({make_lump(cells, 0.2, {1, 1, 1}, step).shape}).empty()) << step << " " << cells;
}

TEST(CreaseEdges, SquaresOfAnEllipsoidAreSoft) {
    for (const double step : {0.0, 1e-5, 1e-4, 1e-3})
        for (const int cells : {6, 12}) {
            EXPECT_TRUE(hard_edges({make_lump(cells, 0, {1, 0.6, 0.4}, step).shape}).empty()) << step << " " << cells;
            std::vector<dvec2> profile;  // squares in planes, not by chance
            for (int i = 0; i <= 2 * cells; ++i)
                profile.push_back({0.6 * std::sin(pi * i / (2 * cells)), -std::cos(pi * i / (2 * cells))});
            profile.front().x = profile.back().x = 0;
            const HardShape turned = make_turned(profile, std::vector<int>(profile.size(), 0), 4 * cells, step);
            EXPECT_TRUE(hard_edges({turned.shape}).empty()) << step << " " << cells;
        }
}

/// A lump cut out of tetrahedra: where two corners of one are inside, a square that lies in a plane.
Shape make_cut_tetrahedra(int cells) {
    const auto field = [](dvec3 p) {
        double sum = -1.2;
        for (const dvec3 c : {dvec3{-0.5, 0, 0.1}, {0.5, 0.2, 0}, {0, -0.5, -0.3}})
            sum += 1 / (0.05 + 4 * dot(p - c, p - c));
        return sum;
    };
    HardBuilder b;
    const auto cut = [&](const dvec3(&corner)[4]) {
        std::vector<dvec3> in, out;
        for (const dvec3 p : corner) (field(p) > 0 ? in : out).push_back(p);
        const auto at = [&](dvec3 p, dvec3 q) {
            if (std::tie(q.x, q.y, q.z) < std::tie(p.x, p.y, p.z)) std::swap(p, q);
            return p + (q - p) * (field(p) / (field(p) - field(q)));
        };
        std::vector<dvec3> ring;
        for (std::size_t i = 0; i < in.size(); ++i)
            for (std::size_t o = 0; o < out.size(); ++o)
                ring.push_back(at(in[i], out[i % 2 == 0 ? o : out.size() - 1 - o]));
        if (ring.empty()) return;
        const bool is_outward = dot(cross(ring[1] - ring[0], ring[2] - ring[0]), out[0] - in[0]) > 0;
        if (!is_outward) std::reverse(ring.begin(), ring.end());
        b.polygon(ring, 0);
    };
    for (int i = 0; i < cells * cells * cells; ++i) {
        const dvec3 low{double(i % cells), double(i / cells % cells), double(i / cells / cells)};
        const auto point = [&](double x, double y, double z) {
            return (low + dvec3{x, y, z}) * (3.2 / cells) - dvec3{1.6, 1.6, 1.6};
        };
        const dvec3 ring[] = {point(1, 0, 0), point(1, 1, 0), point(0, 1, 0),
                              point(0, 1, 1), point(0, 0, 1), point(1, 0, 1)};
        for (int k = 0; k < 6; ++k) cut({point(0, 0, 0), ring[k], ring[(k + 1) % 6], point(1, 1, 1)});
    }
    return b.take().shape;
}

TEST(CreaseEdges, SquaresOfCutTetrahedraAreSoft) {
    for (const int cells : {16, 24}) {
        const Shape lump = make_cut_tetrahedra(cells);
        EXPECT_LT(double(hard_edges({lump}).size()), 0.04 * double(lump.indices.size() / 2)) << cells;
    }
}

/// A knob with a chamfer of 45 degrees below and a fillet above.
HardShape make_knob(int sides, int strips, double step) {
    std::vector<dvec2> profile{{0.9, 0}, {1, 0.1}, {1, 0.8}};
    std::vector<int> ids{1, 2};
    for (int i = 1; i <= strips; ++i) {
        const double a = pi / 2 * i / strips;
        profile.push_back({0.8 + 0.2 * std::cos(a), 0.8 + 0.2 * std::sin(a)}), ids.push_back(2);
    }
    HardShape made = make_turned(profile, ids, sides, step);
    for (int& s : made.surface) s = s == 1001 ? 2 : s;  // the fillet runs into the lid
    return made;
}

TEST(CreaseEdges, FineShapesOfPlanesKeepTheirChamfers) {
    for (const double step : {0.0, 1e-5, 1e-4}) {
        expect_as_meant(make_knob(48, 8, step), "knob");
        expect_as_meant(make_knob(96, 16, step), "fine knob");
    }
    expect_as_meant(make_knob(24, 4, 1e-3), "knob of 3 decimals");
}

TEST(CreaseEdges, WhatRoundingAloneMayBendIsSoft) {
    for (const int sides : {24, 48}) {  // strips that rounding turns by more than 12 degrees
        const HardShape knob = make_knob(sides, 16, 1e-2);
        EXPECT_LT(double(hard_edges({knob.shape}).size()), 2.0 * double(meant_hard(knob).size())) << sides;
    }
}

TEST(CreaseEdges, EachSurfaceShowsAloneWhetherItHasPlanes) {
    const HardShape lump = make_lump(12, 0.2, {1, 1, 1}, 1e-3);
    HardShape box = make_chamfered_box(0.15);
    for (vec3& p : box.shape.positions) p = {0.001f * std::round(1000 * (p.x + 5)), p.y, p.z};
    EXPECT_EQ(hard_edges({lump.shape, box.shape}), hard_edges({box.shape}));
    EXPECT_EQ(hard_edges({box.shape}).size(), meant_hard(box).size());
}

TEST(CreaseEdges, ACurveMayBeginWithASmallBend) {
    // The bends of the edges of a lid, from its middle.
    std::vector<dvec2> profile{{0, 1}};
    double slope = -radians(3.0);
    for (const double bend : {0.0, 0.4, 3.0, 9.0, 30.0, 40.0, 30.0, 20.0, 10.0}) {
        slope -= radians(bend);
        const double length = profile.size() < 2 ? 0.5 : 0.08;
        profile.push_back(profile.back() + dvec2{length * std::cos(slope), length * std::sin(slope)});
    }
    std::reverse(profile.begin(), profile.end());
    for (const int sides : {24, 40}) {
        HardShape lid = make_turned(profile, std::vector<int>(profile.size(), 0), sides);
        EXPECT_EQ(hard_edges({lid.shape}), meant_hard(lid)) << sides;
    }
}

/// A box of half sizes whose edges are rounded: each side is a grid of squares that ends in the middle of the fillets.
/// @param diagonals  0, 1: the same everywhere; 2: alternating
HardShape make_soap(int strips, dvec3 half, double radius, int diagonals) {
    HardBuilder b;
    const auto lines = [&](double h) {
        std::vector<double> out;
        for (const double sign : {-1.0, 1.0})
            for (int i = 0; i <= strips / 2; ++i) {
                const double a = pi / 2 / strips * (sign < 0 ? strips / 2 - i : i);
                out.push_back(sign * (h - radius + radius * std::tan(a)));
            }
        return out;
    };
    const auto onto = [&](dvec3 p) {
        dvec3 q;
        for (std::size_t k = 0; k < 3; ++k) q[k] = std::clamp(p[k], radius - half[k], half[k] - radius);
        return q + (p - q) * (radius / length(p - q));
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            const std::vector<double> x = lines(half[(axis + 1) % 3]), y = lines(half[(axis + 2) % 3]);
            const auto at = [&](std::size_t i, std::size_t j) {
                dvec3 p;
                p[axis] = sign * half[axis], p[(axis + 1) % 3] = x[i], p[(axis + 2) % 3] = y[j];
                return onto(p);
            };
            for (std::size_t i = 0; i + 1 < x.size(); ++i)
                for (std::size_t j = 0; j + 1 < y.size(); ++j) {
                    std::vector<dvec3> square{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
                    const bool is_second = diagonals == 2 ? (i + j) % 2 == 1 : diagonals == 1;
                    if (is_second) std::rotate(square.begin(), square.begin() + 1, square.end());
                    if (sign < 0) std::reverse(square.begin() + 1, square.end());
                    b.polygon(square, 0);
                }
        }
    return b.take();
}

TEST(CreaseEdges, CornersOfRoundedBoxesAreSoftWhateverTheDiagonals) {
    for (const int strips : {2, 4, 6})
        for (const int diagonals : {0, 1, 2}) {
            const HardShape soap = make_soap(strips, {3, 2, 1.2}, 0.5, diagonals);
            EXPECT_TRUE(hard_edges({soap.shape}).empty()) << strips << " " << diagonals;
            const HardShape cube = make_soap(strips, {2, 2, 2}, 1.2, diagonals);
            EXPECT_TRUE(hard_edges({cube.shape}).empty()) << strips << " " << diagonals;
        }
}

/// A square with round corners, and one of another size and radius above: the squares of the corners are twisted.
HardShape make_cap_of_a_key(int strips) {
    HardBuilder b;
    const auto ring = [&](double width, double depth, double radius, double y, double z) {
        std::vector<dvec3> out;
        for (int q = 0; q < 4; ++q)
            for (int i = 0; i <= strips; ++i) {
                const double a = pi / 2 * (q + double(i) / strips), x = width / 2 - radius, w = depth / 2 - radius;
                out.push_back({(q == 0 || q == 3 ? x : -x) + radius * std::cos(a),
                               y + (q < 2 ? w : -w) + radius * std::sin(a), z});
            }
        return out;
    };
    const std::vector<dvec3> low = ring(18, 18, 1.5, 0, 0);
    std::vector<dvec3> high = ring(12.6, 13.6, 2, 0.8, 9.4);
    for (dvec3& p : high) p.z -= 0.9 * (1 - p.x * p.x / 41);  // hollow
    std::vector<dvec3> middle;
    for (std::size_t i = 0; i < low.size(); ++i) middle.push_back(low[i] * 0.45 + high[i] * 0.55);
    b.wall(low, middle, 0);
    b.wall(middle, high, 0);
    b.cap(low, 1000, false);
    b.cap(high, 1001, true);
    return b.take();
}

TEST(CreaseEdges, WallsRunIntoTwistedFillets) {
    for (const int strips : {3, 4, 6})
        for (const Edge& e : hard_edges({make_cap_of_a_key(strips).shape}))  // only rims: nothing that goes up
            EXPECT_LT(std::fabs(std::get<2>(e.first) - std::get<2>(e.second)), 1) << strips;
}

/// A rod with four waves of so many points each, between two collars.
HardShape make_waves(int points, double depth) {
    std::vector<dvec2> profile{{1.3, 0}, {1.3, 0.5}};
    for (int i = 0; i <= 4 * points; ++i)
        profile.push_back({1 + depth * (1 - std::cos(2 * pi * i / points)), 0.5 + 0.25 * i / points});
    profile.insert(profile.end(), {{1.3, 1.5}, {1.3, 2}});
    std::vector<int> ids(profile.size(), 0);
    ids[0] = 1, ids[1] = 2, ids[ids.size() - 3] = 3, ids[ids.size() - 2] = 4;
    return make_turned(profile, ids, 24);
}

TEST(CreaseEdges, CoarseWavesOfTurnedShapesAreSoft) {
    for (const int points : {6, 8, 12})
        for (const Edge& e : hard_edges({make_waves(points, 0.0375).shape})) {
            // Two rings beside the collars may be hard.
            const float z = std::get<2>(e.first), rim = 0.25f * 1.5f / float(points);
            EXPECT_TRUE(z < 0.5f + rim || z > 1.5f - rim) << points << " " << z;
        }
}

TEST(CreaseEdges, OneSmallBendOfATurnedShapeIsSoftAmongSoftOnes) {
    // Hollow below, with a bend of 17 degrees half way; the rim is flat.
    const std::vector<dvec2> profile{{0, 0.28}, {0.48, 0.22}, {0.88, 0.04}, {0.95, 0}, {1, 0}, {1, 2}};
    expect_as_meant(make_turned(profile, {0, 0, 0, 3, 4, 5}, 28), "hollow foot");
}

TEST(CreaseEdges, ShallowBevelsOfPanelsStayHard) {
    // A groove around a field that rises by 11 degrees. Nothing beside these bends is soft.
    HardBuilder b;
    const auto square = [](double inset, double z) {
        const double x = 30 - inset, y = 40 - inset;
        return std::vector<dvec3>{{-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}};
    };
    const std::vector<std::vector<dvec3>> rings{square(0, -4),      square(0, 0),     square(10, 0),
                                                square(11.2, -0.9), square(14, -0.9), square(17.5, -0.2)};
    for (std::size_t i = 0; i + 1 < rings.size(); ++i) b.wall(rings[i], rings[i + 1], 10 * int(i), true);
    b.polygon(std::vector<dvec3>(rings[0].rbegin(), rings[0].rend()), 100);
    b.polygon(rings.back(), 101);
    HardShape made = b.take();
    for (int& s : made.surface) s = s / 10 == 1 || s / 10 == 3 ? s / 10 * 10 : s;  // flat rings are one surface
    expect_as_meant(made, "panel");
}

/// A trapezoidal thread: a profile of heights and radii that rises along a helix. Its ends are open.
HardShape make_thread(int sides, int turns, const std::vector<dvec2>& profile, double pitch) {
    HardBuilder b(1e-6);
    const auto at = [&](int i, std::size_t k) {
        const double a = 2 * pi * (i % sides) / sides;
        return dvec3{profile[k].y * std::cos(a), profile[k].y * std::sin(a), pitch * i / sides + profile[k].x};
    };
    for (int i = 0; i < sides * turns; ++i)
        for (std::size_t k = 0; k + 1 < profile.size(); ++k)
            b.polygon({at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)}, int(k));
    return b.take();
}

TEST(CreaseEdges, ThreadsOfFewPlanesAreHard) {
    // The lands are planes, a fifth of the area; the flanks are twisted squares. The ends may miss an edge at each line.
    for (const int sides : {12, 20, 40}) {
        const HardShape thread = make_thread(sides, 4, {{0, 8}, {0.6, 8}, {1.9, 10}, {2.5, 10}, {4, 8}}, 4);
        const std::set<Edge> hard = hard_edges({thread.shape}), meant = meant_hard(thread);
        for (const Edge& e : hard) EXPECT_EQ(meant.count(e), 1u) << sides;
        EXPECT_GE(hard.size() + 16, meant.size()) << sides;
    }
}

TEST(CreaseEdges, EqualBendsOfUnequalPlanesAreNotRound) {
    const auto bar = [](double cut) {  // a square bar of size 2 with its corners cut off
        const double c = 1 - cut;
        const std::vector<dvec2> profile{{1, -c}, {1, c}, {c, 1}, {-c, 1}, {-1, c}, {-1, -c}, {-c, -1}, {c, -1}};
        return extrude(profile, {0, 1, 2, 3, 4, 5, 6, 7}, 4);
    };
    for (const double cut : {0.1, 0.3, 0.4, 0.45, 0.75}) expect_as_meant(bar(cut), "bar");
    EXPECT_EQ(hard_edges({bar(2 - std::sqrt(2)).shape}).size(), 16u);  // a column of 8 equal sides
}

TEST(CreaseEdges, TheReportHasTheRanges) {
    const CreaseReport r = creases_of({make_column(12, false).shape}).report;
    EXPECT_EQ(r.hard, 24u);
    EXPECT_EQ(r.soft, 12u);
    EXPECT_NEAR(r.hard_least_deg, 90, 0.01);
    EXPECT_NEAR(r.hard_most_deg, 90, 0.01);
    EXPECT_NEAR(r.soft_most_deg, 30, 0.01);
}

/// The faces in another order, each from another corner, vertices renumbered.
Shape renumbered(const Shape& s, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<std::uint32_t> vertex(s.positions.size()), face(s.indices.size() / 3);
    for (std::uint32_t i = 0; i < vertex.size(); ++i) vertex[i] = i;
    for (std::uint32_t i = 0; i < face.size(); ++i) face[i] = i;
    std::shuffle(vertex.begin(), vertex.end(), random);
    std::shuffle(face.begin(), face.end(), random);
    Shape out;
    out.positions.resize(vertex.size());
    for (std::size_t v = 0; v < vertex.size(); ++v) out.positions[vertex[v]] = s.positions[v];
    for (const std::uint32_t t : face)
        for (std::uint32_t k = 0, first = random() % 3; k < 3; ++k)
            out.indices.push_back(vertex[s.indices[3 * t + (first + k) % 3]]);
    return out;
}

TEST(CreaseEdges, NumbersAndCutsDoNotMatter) {
    for (const HardShape& made : all_shapes()) {
        const std::set<Edge> hard = hard_edges({made.shape});
        for (const std::uint32_t seed : {1u, 2u, 3u}) {
            EXPECT_EQ(hard_edges({renumbered(made.shape, seed)}), hard);
            std::vector<Shape> parts = cut_at_random(made.shape, 4, seed);
            EXPECT_EQ(hard_edges(parts), hard);
            std::reverse(parts.begin(), parts.end());
            EXPECT_EQ(hard_edges(parts), hard);
        }
    }
}

TEST(CreaseEdges, PlacementDoesNotMatter) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> angle(0, pi);
    for (const HardShape& made : all_shapes()) {
        const std::set<Edge> hard = hard_edges({made.shape});
        for (const double scale : {1e-6, 1.0, 1e6})
            for (const double mirror : {1.0, -1.0}) {
                const double a = angle(random), c = std::cos(a), s = std::sin(a);
                Shape placed = made.shape;
                placed.to_world[0] = {scale * c, scale * s, 0, 0};
                placed.to_world[1] = {0, 0, mirror * scale, 0};
                placed.to_world[2] = {scale * s, -scale * c, 0, 0};
                placed.to_world[3] = {3 * scale, 1 * scale, -2 * scale, 1};
                EXPECT_EQ(hard_edges({placed}), hard) << scale << " " << mirror;
            }
    }
}

TEST(CreaseEdges, ThreadsDoNotMatter) {
    const std::vector<Shape> shapes{make_torus(300, 150), make_nut(1e-3, 0.1).shape};
    const Creases one = creases_of(shapes, 1), many = creases_of(shapes, 4);
    EXPECT_EQ(one.hard, many.hard);
    EXPECT_EQ(one.report, many.report);
}

TEST(CreaseEdges, SidesOfAShellAreDecidedAlone) {
    Shape shell = make_cylinder(12, 1);
    const std::size_t count = shell.indices.size();
    for (std::size_t c = 0; c < count; c += 3)
        shell.indices.insert(shell.indices.end(), {shell.indices[c], shell.indices[c + 2], shell.indices[c + 1]});
    const Creases creases = creases_of({shell});
    for (std::size_t c = 0; c < shell.indices.size(); ++c) {
        const bool is_rim =
            shell.positions[shell.indices[c]].y == shell.positions[shell.indices[c - c % 3 + (c + 1) % 3]].y;
        EXPECT_EQ(creases.hard[0][c / 3] >> c % 3 & 1, is_rim);
    }
}

TEST(CreaseEdges, AWallOnAFloorIsHardAndTheFloorIsNot) {
    Shape s;
    s.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 0, 0}, {-1, 1, 0}, {0, 0, 1}, {0, 1, 1}};
    s.indices = {0, 1, 2, 0, 2, 3, 4, 0, 3, 4, 3, 5, 0, 3, 7, 0, 7, 6};
    const Creases creases = creases_of({s});
    EXPECT_EQ(creases.hard[0], (std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0}));
}

TEST(CreaseEdges, BadFacesAreLeftOut) {
    HardShape nut = make_nut(1e-3, 0.1);
    const std::set<Edge> hard = hard_edges({nut.shape});
    Shape& s = nut.shape;
    const std::uint32_t bad = std::uint32_t(s.positions.size());
    s.positions.push_back({NAN, 0, 0});
    s.indices.insert(s.indices.end(), {0, 1, bad, 0, 0, 1, 2, 1, 2});
    EXPECT_EQ(hard_edges({s}), hard);
    EXPECT_TRUE(hard_edges({Shape{}}).empty());
    EXPECT_TRUE(creases_of({}).hard.empty());
}

}  // namespace
}  // namespace rakelight::test
