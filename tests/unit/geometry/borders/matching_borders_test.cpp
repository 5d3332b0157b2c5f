// SPDX-License-Identifier: Apache-2.0
// Borders that run along each other without shared vertices: closed forms whose error against the surface's own normals must
// fall with the seam, what must stay apart, measures against brute force, threads, and crowds of edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "geometry/borders/border_proposal.h"
#include "unit/geometry/borders/border_shapes.h"

namespace rakelight::test {
namespace {

struct Joined {
    std::vector<Shape> shapes;
    MatchReport report;
    BorderMeasure before, after;
};

double degrees_between(dvec3 a, dvec3 b) { return degrees(std::atan2(length(cross(a, b)), dot(a, b))); }

std::vector<Shape> smoothed(const std::vector<Shape>& shapes, const AttributeOptions& options = {}) {
    const std::vector<MeshAttributes> made = compute(shapes, options);
    std::vector<Shape> out;
    for (std::size_t m = 0; m < shapes.size(); ++m) out.push_back(with_attributes(shapes[m], made[m]));
    return out;
}

std::vector<Shape> applied(std::vector<Shape> shapes, const std::vector<MeshSeams>& turned) {
    for (std::size_t m = 0; m < shapes.size(); ++m)
        for (std::size_t i = 0; i < turned[m].vertices.size(); ++i)
            shapes[m].normals[turned[m].vertices[i]] = turned[m].normals[i];
    return shapes;
}

Joined join(const std::vector<Shape>& shapes, const MatchOptions& options, int threads = 2) {
    Context context({.threads = threads});
    Joined out;
    out.before = measure_borders(views(shapes), options, context);
    const BorderMatch match = match_borders(views(shapes), options, context);
    out.shapes = applied(shapes, join_borders(match, views(shapes), {}, out.report, context));
    out.after = measure_borders(views(out.shapes), options, context);
    return out;
}

/// Mean over the border vertices at the cut [degrees].
double mean_error(const std::vector<Shape>& shapes, const std::vector<std::vector<dvec3>>& truth,
                  const std::vector<Shape>& turned) {
    double sum = 0;
    int count = 0;
    for (std::size_t m = 0; m < shapes.size(); ++m)
        for (std::size_t v = 0; v < truth[m].size(); ++v)
            if (turned[m].normals[v] != shapes[m].normals[v]) {
                sum += degrees_between(cast<double>(shapes[m].normals[v]), truth[m][v]);
                ++count;
            }
    return count == 0 ? 0 : sum / count;
}

class ClosedForms : public testing::TestWithParam<Cut> {};

TEST_P(ClosedForms, SeamAndErrorFall) {
    const Cut cut = GetParam();
    for (const auto& [name, surface] : {std::pair<const char*, Surface>{"bumpy sphere", bumpy_sphere()},
                                        {"torus", torus()},
                                        {"cylinder", cylinder()}}) {
        SCOPED_TRACE(name);
        const CutSurface model = cut_surface(surface, cut);
        const std::vector<Shape> made = smoothed(model.halves);
        const double reach = (0.05 + cut.gap + 2 * cut.noise) * model.edge;
        const Joined joined = join(made, {.distance = std::max(reach, 0.15 * model.edge)});
        const double before = mean_error(made, model.truth, joined.shapes),
                     after = mean_error(joined.shapes, model.truth, made);
        EXPECT_GT(joined.report.following, 0u);
        EXPECT_LT(joined.after.seam.mean_deg, joined.before.seam.mean_deg * 0.1 + 0.02);
        // straight interpolation is off an arc of 15 degrees by 0.03 at most
        EXPECT_LT(after, std::max(before, 0.03));
    }
}

INSTANTIATE_TEST_SUITE_P(Cuts, ClosedForms,
                         testing::Values(Cut{.times = 2}, Cut{.times = 3}, Cut{.times = 5}, Cut{.phase = 0.37},
                                         Cut{.times = 2, .phase = 0.5}, Cut{.times = 3, .phase = 0.21}, Cut{.gap = 0.1},
                                         Cut{.times = 2, .gap = 0.3}, Cut{.times = 5, .gap = 0.2},
                                         Cut{.times = 3, .phase = 0.4, .gap = 0.1, .noise = 0.03},
                                         Cut{.times = 2, .gap = 0.3, .noise = 0.05}));

/// A flat sheet with given normals, from a corner along two edges; faces look along cross(right, up).
Shape sheet(std::uint32_t columns, std::uint32_t rows, dvec3 corner, dvec3 right, dvec3 up, std::uint32_t object,
            dvec3 normal) {
    Shape s = make_grid(columns, rows, [&](double u, double v) { return cast<float>(corner + right * u + up * v); });
    s.normals.assign(s.positions.size(), cast<float>(normalize_or(normal, dvec3{})));
    s.object = object;
    return s;
}
/// Leaning away from z by some degrees about x.
dvec3 leaning(double deg) { return {0, std::sin(radians(deg)), std::cos(radians(deg))}; }

/// Two sheets in the plane z = 0 with a gap of 0.02 between y = 1 and y = 1.02; the upper one has three times the columns.
std::vector<Shape> two_sheets() {
    return {sheet(4, 2, {0, 0, 0}, {4, 0, 0}, {0, 1, 0}, 0, leaning(-10)),
            sheet(12, 2, {0, 1.02, 0}, {4, 0, 0}, {0, 1, 0}, 1, leaning(10))};
}

TEST(MatchingBorders, LeadingNormalsAreVotesByAnglesSharedOutByHats) {
    const Joined joined = join(two_sheets(), {.distance = 0.05});
    EXPECT_EQ(joined.report.leading, 5u);
    EXPECT_EQ(joined.report.following, 13u);
    EXPECT_NEAR(joined.before.seam.max_deg, 20, 1e-4);
    EXPECT_NEAR(joined.before.seam.mean_deg, 20, 1e-4);
    EXPECT_NEAR(joined.after.seam.max_deg, 0, 0.02);
    EXPECT_NEAR(joined.before.matched_length, 8, 1e-5);
    EXPECT_NEAR(joined.before.open_length, 20, 1e-5);
    EXPECT_NEAR(joined.before.gap_max, 0.02, 1e-6);
    // In the middle a leading vertex has half a turn of faces of its own, and 1/3 + 2/3 + 1 + 2/3 + 1/3 halves of others.
    const dvec3 expected = normalize_or(leaning(-10) + leaning(10) * 3.0, dvec3{});
    const std::uint32_t middle = 2 * 5 + 2;
    EXPECT_LT(degrees_between(cast<double>(joined.shapes[0].normals[middle]), expected), 1e-4);
    // One that follows at a third of the edge between two equal ones has their normal.
    EXPECT_LT(degrees_between(cast<double>(joined.shapes[1].normals[6]), expected), 1e-4);
}

TEST(MatchingBorders, OffTheBorderEveryBitStays) {
    const std::vector<Shape> before = two_sheets();
    const Joined joined = join(before, {.distance = 0.05});
    for (std::size_t m = 0; m < 2; ++m)
        for (std::size_t v = 0; v < before[m].normals.size(); ++v) {
            const float y = before[m].positions[v].y;
            const bool is_border = m == 0 ? y == 1 : y < 1.03f;
            EXPECT_EQ(joined.shapes[m].normals[v] != before[m].normals[v], is_border) << m << " " << v;
        }
}

TEST(MatchingBorders, BeyondTheDistanceNothingMatches) {
    EXPECT_EQ(join(two_sheets(), {.distance = 0.0199}).report.following, 0u);
    EXPECT_EQ(join(two_sheets(), {.distance = 0.0201}).report.following, 13u);
}

TEST(MatchingBorders, TheScopeAndTheCreaseAngleRule) {
    std::vector<Shape> shapes = two_sheets();
    EXPECT_EQ(join(shapes, {.distance = 0.05, .scope = Scope::object}).report.following, 0u);
    EXPECT_EQ(join(shapes, {.distance = 0.05, .scope = Scope::face}).report.following, 0u);
    for (Shape& s : shapes) s.object = 5;
    EXPECT_EQ(join(shapes, {.distance = 0.05, .scope = Scope::object}).report.following, 13u);
    const auto bent = [](double deg) {
        std::vector<Shape> two = two_sheets();
        two[1] =
            sheet(12, 2, {0, 1.02, 0}, {4, 0, 0}, {0, std::cos(radians(deg)), std::sin(radians(deg))}, 1, leaning(0));
        return two;
    };
    EXPECT_EQ(join(bent(59), {.distance = 0.05}).report.following, 13u);
    EXPECT_EQ(join(bent(61), {.distance = 0.05}).report.following, 0u);
    EXPECT_EQ(join(bent(61), {.distance = 0.05, .crease_angle_rad = radians(62)}).report.following, 13u);
}

TEST(MatchingBorders, FlatFacesThatSomebodyAuthoredStayApart) {
    std::vector<Shape> shapes = two_sheets();
    shapes[0] = sheet(4, 2, {0, 0, 0}, {4, 0, 0}, {0, 1, 0}, 0, leaning(0));
    shapes[1] = sheet(12, 2, {0, 1.02, 0}, {4, 0, 0}, {0, 1, 0.3}, 1, cross(dvec3{1, 0, 0}, dvec3{0, 1, 0.3}));
    EXPECT_EQ(join(shapes, {.distance = 0.05, .keep_flat = true}).report.following, 0u);
    EXPECT_EQ(join(shapes, {.distance = 0.05}).report.following, 13u);
}

TEST(MatchingBorders, WhatOnlyLiesNearStaysApart) {
    const double d = 0.1;
    const auto apart = [&](const char* what, std::vector<Shape> shapes) {
        EXPECT_EQ(join(shapes, {.distance = d}).report.turned, 0u) << what;
    };
    const dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    apart("plates on each other",
          {sheet(3, 3, {0, 0, 0}, x, y, 0, leaning(5)), sheet(5, 5, {0.02, 0.02, 0.04}, x, y, 1, leaning(-5))});
    apart("alternatives in one place",
          {sheet(3, 3, {0, 0, 0}, x, y, 0, leaning(5)), sheet(4, 4, {0, 0, 0}, x, y, 1, leaning(-5))});
    apart("shells back to back",
          {sheet(3, 3, {0, 0, 0}, x, y, 0, leaning(5)), sheet(4, 4, {0, 0, -0.05}, y, x, 1, leaning(175))});
    apart("walls that face each other",
          {sheet(3, 3, {0, 0, 0}, x, y, 0, leaning(5)), sheet(4, 4, {0, 0, 0.08}, y, x, 1, leaning(175))});
    apart("a collar", {sheet(3, 3, {0, 0, 0}, x, y, 0, leaning(5)), sheet(4, 4, {0, 1.02, 0}, x, z, 1, leaning(-80))});
    apart("scales", {sheet(3, 3, {0, 0, 0}, x, y, 0, leaning(5)), sheet(4, 4, {0, 0.92, 0.03}, x, y, 1, leaning(-5))});
    apart("a border on a surface",
          {sheet(8, 8, {-1, -1, 0}, x * 3.0, y * 3.0, 0, leaning(5)), sheet(4, 4, {0, 0, 0.03}, x, y, 1, leaning(-5))});
}

TEST(MatchingBorders, WeldedVerticesStayEqualToTheBit) {
    const CutSurface model = cut_surface(bumpy_sphere(), {.times = 3});
    const Joined joined = join(smoothed(model.halves), {.distance = 0.2 * model.edge});
    const Shape &low = joined.shapes[0], &high = joined.shapes[1];
    std::map<std::tuple<float, float, float>, vec3> at;
    for (std::size_t v = 0; v < low.positions.size(); ++v)
        at[{low.positions[v].x, low.positions[v].y, low.positions[v].z}] = low.normals[v];
    int shared = 0;
    for (std::size_t v = 0; v < high.positions.size(); ++v) {
        const auto known = at.find({high.positions[v].x, high.positions[v].y, high.positions[v].z});
        if (known == at.end()) continue;
        ++shared;
        EXPECT_EQ(known->second, high.normals[v]);
    }
    EXPECT_GE(shared, 24);
}

TEST(MatchingBorders, AHardEdgeThatEndsAtTheBorderStaysHard) {
    // The finer side has two normals at x = 2, 40 degrees apart; so has the coarser one, at other vertices.
    const auto roof = [](std::uint32_t columns, double y, std::uint32_t object) {
        Shape s;
        for (const int side : {0, 1}) {
            const dvec3 right = side == 0 ? dvec3{2, 0, 0.7} : dvec3{2, 0, -0.7};
            const Shape half = sheet(columns, 1, side == 0 ? dvec3{0, y, 0} : dvec3{2, y, 0.7}, right, {0, 1, 0},
                                     object, cross(right, dvec3{0, 1, 0}) + dvec3{0, y < 0.5 ? 0.2 : -0.2, 0});
            const std::uint32_t base = std::uint32_t(s.positions.size());
            s.positions.insert(s.positions.end(), half.positions.begin(), half.positions.end());
            s.normals.insert(s.normals.end(), half.normals.begin(), half.normals.end());
            for (const std::uint32_t i : half.indices) s.indices.push_back(base + i);
        }
        s.object = object;
        return s;
    };
    const std::vector<Shape> shapes{roof(2, 0, 0), roof(6, 1.01, 1)};
    const Joined joined = join(shapes, {.distance = 0.05, .crease_angle_rad = radians(80)});
    EXPECT_GT(joined.report.following, 0u);
    for (const Shape& s : joined.shapes)
        for (std::size_t a = 0; a < s.positions.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                if (s.positions[a] == s.positions[b]) {
                    EXPECT_GT(degrees_between(cast<double>(s.normals[a]), cast<double>(s.normals[b])), 35);
                }
    EXPECT_LT(joined.after.seam.p95_deg, 0.05);
}

TEST(MatchingBorders, ThreePanelsMeetAtACorner) {
    // Two panels above one: both follow it below; at the corner where all three meet they agree.
    const std::vector<Shape> shapes{sheet(3, 2, {0, 0, 0}, {4, 0, 0}, {0, 1, 0}, 0, leaning(-8)),
                                    sheet(7, 5, {0, 1.01, 0}, {1.99, 0, 0}, {0, 1, 0}, 1, leaning(8)),
                                    sheet(10, 9, {2, 1.01, 0}, {2, 0, 0}, {0, 1, 0}, 2, {0.15, 0, 1})};
    const Joined joined = join(shapes, {.distance = 0.05});
    EXPECT_LT(joined.after.seam.max_deg, 0.5);
    EXPECT_GT(joined.before.seam.max_deg, 10);
}

TEST(MatchingBorders, FacesAreSeenInTheWorld) {
    std::vector<Shape> shapes = two_sheets();
    const dmat4 mirror = scaling(dvec3{-2, 0.5, 4}) * translation(dvec3{1, 2, 3});
    Shape& upper = shapes[1];
    const dmat4 back = translation(dvec3{-1, -2, -3}) * scaling(dvec3{-0.5, 2, 0.25});
    for (vec3& p : upper.positions) p = cast<float>(transform_point(back, cast<double>(p)));
    for (vec3& n : upper.normals)
        n = cast<float>(normalize_or(dvec3{double(n.x) * -2, n.y * 0.5, double(n.z) * 4}, dvec3{}));
    for (std::size_t t = 0; t < upper.indices.size(); t += 3) std::swap(upper.indices[t + 1], upper.indices[t + 2]);
    upper.to_world = mirror;
    const Joined joined = join(shapes, {.distance = 0.05});
    EXPECT_EQ(joined.report.following, 13u);
    EXPECT_NEAR(joined.before.seam.mean_deg, 20, 1e-3);
    EXPECT_LT(joined.after.seam.max_deg, 0.02);
}

TEST(MatchingBorders, TangentsFollowWhereChartsAgree) {
    const std::vector<Shape> shapes = two_sheets();
    std::vector<std::vector<vec4>> tangents{std::vector<vec4>(shapes[0].positions.size(), vec4{1, 0, 0, 1}),
                                            std::vector<vec4>(shapes[1].positions.size(), vec4{0.9f, 0, 0, 1})};
    for (vec4& t : tangents[1]) t = {float(std::cos(0.3)), float(std::sin(0.3)), 0, 1};
    const auto run = [&](const std::vector<std::vector<vec4>>& given) {
        Context context;
        MatchReport report;
        const std::vector<std::span<const vec4>> spans{given[0], given[1]};
        return join_borders(match_borders(views(shapes), {.distance = 0.05}, context), views(shapes), spans, report,
                            context);
    };
    const std::vector<MeshSeams> turned = run(tangents);
    // By 1 : 3, as the normals.
    const double expected = std::atan2(3 * std::sin(0.3), 1 + 3 * std::cos(0.3));
    for (const MeshSeams& mesh : turned) {
        ASSERT_EQ(mesh.tangents.size(), mesh.vertices.size());
        for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
            const vec4 t = mesh.tangents[i];
            EXPECT_EQ(t.w, 1);
            EXPECT_NEAR(std::atan2(t.y, t.x), expected, 0.02);
            EXPECT_NEAR(dot(t.xyz(), mesh.normals[i]), 0, 1e-6);
        }
    }
    std::vector<Shape> joined = applied(shapes, turned);
    for (std::size_t m = 0; m < 2; ++m)
        for (std::size_t i = 0; i < turned[m].vertices.size(); ++i)
            tangents[m][turned[m].vertices[i]] = turned[m].tangents[i];
    Context context;
    MatchReport report;
    const std::vector<std::span<const vec4>> spans{tangents[0], tangents[1]};
    for (const MeshSeams& mesh :
         join_borders(match_borders(views(joined), {.distance = 0.05}, context), views(joined), spans, report, context))
        EXPECT_TRUE(mesh.vertices.empty());  // what agrees stays
    for (vec4& t : tangents[1]) t.w = -1;    // another handedness: each turns along with its normal
    for (const MeshSeams& mesh : run(tangents))
        for (const vec4 t : mesh.tangents) EXPECT_EQ(t.w, 0);
}

TEST(MatchingBorders, AMatchServesOtherPoses) {
    std::vector<Shape> shapes = two_sheets();
    Context context;
    const BorderMatch match = match_borders(views(shapes), {.distance = 0.05}, context);
    const auto turned = [](vec3 v) { return vec3{v.x, -v.z, v.y}; };
    std::vector<Shape> posed = shapes;
    for (Shape& s : posed) {
        for (vec3& p : s.positions) p = turned(p);
        for (vec3& n : s.normals) n = turned(n);
    }
    MatchReport report;
    const std::vector<Shape> a = applied(shapes, join_borders(match, views(shapes), {}, report, context)),
                             b = applied(posed, join_borders(match, views(posed), {}, report, context));
    EXPECT_EQ(report.following, 13u);
    for (std::size_t m = 0; m < 2; ++m)
        for (std::size_t v = 0; v < a[m].normals.size(); ++v)
            EXPECT_LT(length(turned(a[m].normals[v]) - b[m].normals[v]), 1e-6);
    posed[1].positions.push_back({});
    posed[1].normals.push_back({});
    EXPECT_THROW(join_borders(match, views(posed), {}, report, context), Error);
    posed.pop_back();
    EXPECT_THROW(join_borders(match, views(posed), {}, report, context), Error);
}

TEST(MatchingBorders, WhatWasJoinedStays) {
    for (const Cut cut : {Cut{.times = 3, .phase = 0.3}, Cut{.times = 2, .gap = 0.2, .noise = 0.05}}) {
        const CutSurface model = cut_surface(bumpy_sphere(), cut);
        const MatchOptions options{.distance = 0.4 * model.edge};
        const Joined once = join(smoothed(model.halves), options), twice = join(once.shapes, options);
        EXPECT_GT(once.report.turned, 20u);
        EXPECT_EQ(twice.report.turned, 0u) << twice.report.max_deg;
    }
}

TEST(MatchingBorders, OptionsAreChecked) {
    Context context;
    for (const double wrong : {0.0, -1.0, std::nan(""), double(INFINITY)})
        EXPECT_THROW(match_borders(views(two_sheets()), {.distance = wrong}, context), Error) << wrong;
    EXPECT_THROW(match_borders(views(two_sheets()), {.distance = 1, .scope = Scope(7)}, context), Error);
    EXPECT_THROW(measure_borders(views(two_sheets()), {.distance = 1, .crease_angle_rad = 4}, context), Error);
    std::vector<Shape> bare = two_sheets();
    bare[0].normals.clear();
    EXPECT_THROW(match_borders(views(bare), {.distance = 1}, context), Error);
    EXPECT_TRUE(match_borders({}, {.distance = 1}, context).is_empty());
}

TEST(MatchingBorders, NormalsThatAreOfNoUseTakeNoPart) {
    std::vector<Shape> shapes = two_sheets();
    for (vec3& n : shapes[1].normals) n = {};
    EXPECT_EQ(join(shapes, {.distance = 0.05}).report.turned, 0u);
    for (vec3& n : shapes[1].normals) n = {NAN, 0, 0};
    EXPECT_EQ(join(shapes, {.distance = 0.05}).report.turned, 0u);
    for (vec3& p : shapes[1].positions) p = {NAN, 0, 0};
    EXPECT_EQ(join(shapes, {.distance = 0.05}).report.turned, 0u);
}

TEST(MatchingBorders, TheProposedDistanceFindsTheGap) {
    Context context;
    for (const double gap : {0.05, 0.1, 0.3}) {
        const CutSurface model = cut_surface(torus(), {.times = 3, .gap = gap});
        const std::vector<Shape> made = smoothed(model.halves);
        const double d = geometry::propose_distance(views(made), {}, context).distance;
        EXPECT_GT(d, gap * model.edge);
        EXPECT_LT(d, 1.6 * gap * model.edge + 0.1 * model.edge);
        EXPECT_LT(join(made, {.distance = d}).after.seam.mean_deg, 0.3);
    }
    EXPECT_EQ(geometry::propose_distance(views(smoothed({make_cube()})), {}, context).distance, 0);
}

/// Random triangles of several meshes crowded in a small box, some of them side by side.
std::vector<Shape> crowd(std::uint32_t triangles, std::uint32_t meshes, double size, unsigned seed) {
    std::mt19937 random(seed);
    const auto number = [&] { return double(random()) / 4294967296.0; };
    const auto vector = [&] { return dvec3{number() - 0.5, number() - 0.5, number() - 0.5}; };
    std::vector<Shape> shapes(meshes);
    for (std::uint32_t t = 0; t < triangles; ++t) {
        Shape& s = shapes[random() % meshes];
        const dvec3 at = vector() * size, along = vector();
        dvec3 out = cross(along, vector());
        const std::uint32_t first = std::uint32_t(s.positions.size());
        for (const dvec3 p : {at, at + along, at + out * (random() % 2 ? 1.0 : -1.0)}) {
            s.positions.push_back(cast<float>(p));
            s.normals.push_back(cast<float>(normalize_or(vector(), dvec3{1, 0, 0})));
        }
        s.indices.insert(s.indices.end(), {first, first + 1, first + 2});
    }
    for (std::uint32_t m = 0; m < meshes; ++m) shapes[m].object = m / 2;
    return shapes;
}

/// What measure_borders() says, told again: every point against every edge; of the edges of one triangle that match one
/// mesh, a tenth of whose length is less than the distance, nothing counts.
BorderMeasure brute_force(const std::vector<Shape>& shapes, double d, double crease_rad) {
    struct Edge {
        std::size_t mesh, triangle;
        dvec3 a, b, na, nb, face;
    };
    std::vector<Edge> edges;
    for (std::size_t m = 0; m < shapes.size(); ++m)  // each triangle of a crowd stands alone: all edges are open
        for (std::size_t t = 0; t < shapes[m].indices.size(); t += 3)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto p = [&](std::size_t i) {
                    return cast<double>(shapes[m].positions[shapes[m].indices[t + i % 3]]);
                };
                const auto n = [&](std::size_t i) {
                    return normalize_or(cast<double>(shapes[m].normals[shapes[m].indices[t + i % 3]]), dvec3{});
                };
                edges.push_back(
                    {m, t, p(k), p(k + 1), n(k), n(k + 1), normalize_or(cross(p(1) - p(0), p(2) - p(0)), dvec3{})});
            }
    BorderMeasure out;
    std::vector<std::array<std::size_t, 3>> runs;  // [samples] mesh, triangle, other mesh
    std::map<std::array<std::size_t, 3>, double> lengths;
    std::vector<double> pieces;
    for (const Edge& e : edges) {
        out.open_length += length(e.b - e.a);
        for (int k = 0; k < 4; ++k) {
            const double u = (k + 0.5) / 4;
            const dvec3 p = e.a + (e.b - e.a) * u, n = normalize_or(e.na * (1 - u) + e.nb * u, dvec3{}),
                        ea = normalize_or(e.b - e.a, dvec3{});
            double best = INFINITY, deg = 0, gap = 0;
            std::size_t other = 0;
            for (const Edge& f : edges) {
                const dvec3 fa = normalize_or(f.b - f.a, dvec3{});
                if (f.mesh == e.mesh || dot(e.face, f.face) < std::cos(crease_rad) || dot(ea, fa) > -0.5) continue;
                const double t = std::clamp(dot(p - f.a, fa) / length(f.b - f.a), 0.0, 1.0);
                const dvec3 g = f.a + (f.b - f.a) * t - p, nf = normalize_or(f.na * (1 - t) + f.nb * t, dvec3{});
                if (length(g) > d || dot(g, cross(e.face, ea)) > d / 2 || -dot(g, cross(f.face, fa)) > d / 2) continue;
                const double rank = dot(g, g) + d * d / 16 * (1 - dot(n, nf));
                if (rank < best) best = rank, deg = degrees_between(n, nf), gap = length(g), other = f.mesh;
            }
            if (best == INFINITY) continue;
            out.samples.push_back({.a = e.a + (e.b - e.a) * (k / 4.0), .deg = deg, .gap = gap});
            runs.push_back({e.mesh, e.triangle, other});
            lengths[runs.back()] += length(e.b - e.a) / 4;
            pieces.push_back(length(e.b - e.a) / 4);
        }
    }
    std::vector<BorderSample> kept;
    for (std::size_t i = 0; i < runs.size(); ++i)
        if (lengths[runs[i]] >= 10 * d) kept.push_back(out.samples[i]), out.matched_length += pieces[i];
    out.samples = kept;
    return out;
}

TEST(MatchingBorders, MeasuresAgreeWithBruteForce) {
    std::size_t samples = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        const std::vector<Shape> shapes = crowd(60 + seed % 60, 2 + seed % 5, 0.3, seed);
        Context context({.threads = 2});
        const double d = 0.02 + 0.0003 * seed, crease = radians(50 + seed % 100);
        const BorderMeasure found =
                                measure_borders(views(shapes), {.distance = d, .crease_angle_rad = crease}, context),
                            expected = brute_force(shapes, d, crease);
        EXPECT_EQ(found.edges_not_searched, 0u);
        EXPECT_NEAR(found.open_length, expected.open_length, 1e-6);
        EXPECT_NEAR(found.matched_length, expected.matched_length, 1e-6) << seed;
        ASSERT_EQ(found.samples.size(), expected.samples.size()) << seed;
        for (std::size_t i = 0; i < found.samples.size(); ++i) {
            EXPECT_NEAR(found.samples[i].deg, expected.samples[i].deg, 1e-4) << seed;
            EXPECT_NEAR(found.samples[i].gap, expected.samples[i].gap, 1e-6) << seed;
        }
        samples += found.samples.size();
    }
    EXPECT_GT(samples, 1000u);
}

TEST(MatchingBorders, BitsDoNotDependOnThreadsOrOtherMeshes) {
    const std::vector<Shape> shapes = crowd(400, 6, 0.3, 3);
    const Joined one = join(shapes, {.distance = 0.03, .crease_angle_rad = radians(150)}, 1);
    EXPECT_GT(one.report.following, 20u);
    for (const int threads : {2, 3, 8}) {
        const Joined more = join(shapes, {.distance = 0.03, .crease_angle_rad = radians(150)}, threads);
        EXPECT_EQ(one.report, more.report);
        for (std::size_t m = 0; m < shapes.size(); ++m) EXPECT_EQ(one.shapes[m].normals, more.shapes[m].normals);
    }
}

TEST(MatchingBorders, ACrowdOfEdgesInOneCellIsGivenUpNotSearchedForEver) {
    const std::vector<Shape> shapes = crowd(30'000, 3, 1e-3, 1);
    Context context;
    const BorderMatch match = match_borders(views(shapes), {.distance = 1, .crease_angle_rad = radians(5)}, context);
    MatchReport report;
    join_borders(match, views(shapes), {}, report, context);
    EXPECT_GT(report.vertices_not_searched, 1000u);
}

}  // namespace
}  // namespace rakelight::test
