// SPDX-License-Identifier: Apache-2.0
#include "geometry/refine/subdivide.h"

#include <gtest/gtest.h>

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "geometry/refine/subdivision_masks.h"
#include "math/linear.h"
#include "unit/geometry/refine/polygons.h"

namespace rakelight::geometry {
namespace {

using test::Faces, test::polygons;

/// Corners at +-1.
ControlSurface cube() {
    ControlSurface s;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) s.positions.push_back({x, y, z});
    s.faces = polygons({{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}});
    return s;
}

/// A closed fan of n triangles or quads about vertex 0 and two rings of them, bent in space.
ControlSurface disc(Scheme scheme, int n, int rings, int faces_cut_away = 0) {
    ControlSurface s;
    s.scheme = scheme;
    const auto at = [&](int ring, int i) {
        return ring == 0 ? 0u : std::uint32_t(1 + (ring - 1) * 2 * n + i % (2 * n));
    };
    s.positions.push_back({0, 0, 0.3});
    for (int ring = 1; ring <= rings; ++ring)
        for (int i = 0; i < 2 * n; ++i) {
            const double a = pi * i / n, r = ring * (1 + 0.15 * std::sin(3 * a + ring));
            s.positions.push_back({r * std::cos(a), r * std::sin(a), 0.3 * std::sin(2 * a + 0.7 * ring) - 0.1 * r * r});
        }
    Faces faces;
    for (int i = 0; i < n - faces_cut_away; ++i) {  // wedge by wedge
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
            if (scheme == Scheme::loop) {
                faces.push_back({a, b, c});
                faces.push_back({a, c, d});
            } else {
                faces.push_back({a, b, c, d});
            }
        };
        if (scheme == Scheme::loop) {
            faces.push_back({0, at(1, 2 * i), at(1, 2 * i + 2)});
            faces.push_back({at(1, 2 * i), at(1, 2 * i + 1), at(1, 2 * i + 2)});
        } else {
            add(0, at(1, 2 * i), at(1, 2 * i + 1), at(1, 2 * i + 2));
        }
        for (int ring = 1; ring < rings; ++ring)
            for (int k = 2 * i; k < 2 * i + 2; ++k)
                add(at(ring, k), at(ring + 1, k), at(ring + 1, k + 1), at(ring, k + 1));
    }
    s.faces = polygons(faces);
    return s;
}

std::vector<dvec3> limit(ControlSurface s, int level) {
    Context context;
    s.level = level;
    return subdivide(s, context).positions;
}

double distance_to(const std::vector<dvec3>& points, dvec3 p) {
    double least = 1e300;
    for (const dvec3 q : points) least = std::min(least, length(q - p));
    return least;
}

TEST(Subdivide, CatmullClarksCubeHasThePointsOfItsClosedForm) {
    // Halstead et al. 1993: (n^2 v + 4 sum e + sum f) / (n (n + 5)): (9 + 4 - 1) / 24 at a corner. At a side's middle,
    // from the first level (face 1, edges 3/4, corners 5/9): (16 + 4 * 3 + 20/9) / 36.
    for (const int level : {1, 2, 4}) {
        const std::vector<dvec3> points = limit(cube(), level);
        EXPECT_LT(distance_to(points, {0.5, 0.5, 0.5}), 1e-15) << level;
        EXPECT_LT(distance_to(points, {-0.5, 0.5, -0.5}), 1e-15) << level;
        EXPECT_LT(distance_to(points, {68.0 / 81, 0, 0}), 1e-15) << level;
        EXPECT_LT(distance_to(points, {0, 0, -68.0 / 81}), 1e-15) << level;
    }
}

TEST(Subdivide, LoopsOctahedronHasThePointsOfItsClosedForm) {
    ControlSurface s;
    s.scheme = Scheme::loop;
    s.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    s.faces = polygons({{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
    // Loop 1987 with n = 4: beta = 31/256, a neighbor's weight in the limit 1 / (4 + 3 / (8 beta)) = 31/220
    for (const int level : {1, 3}) {
        const std::vector<dvec3> points = limit(s, level);
        EXPECT_LT(distance_to(points, {24.0 / 55, 0, 0}), 1e-15) << level;
        EXPECT_LT(distance_to(points, {0, 0, -24.0 / 55}), 1e-15) << level;
    }
}

TEST(Subdivide, TheLimitIsTheSameFromWhateverLevelItIsTaken) {
    for (const Scheme scheme : {Scheme::catmull_clark, Scheme::loop})
        for (const int n : {3, 5, 7}) {
            const std::vector<dvec3> fine = limit(disc(scheme, n, 2, n == 5 ? 2 : 0), 3);
            for (const dvec3 p : limit(disc(scheme, n, 2, n == 5 ? 2 : 0), 1))
                EXPECT_LT(distance_to(fine, p), 1e-14) << n;
        }
}

TEST(Subdivide, AFlatSheetStaysFlatAndKeepsItsArea) {
    Context context;
    for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark}) {
        ControlSurface s;
        s.scheme = scheme;
        s.level = 3;
        Faces faces;
        for (int y = 0; y <= 4; ++y)
            for (int x = 0; x <= 4; ++x) {
                const bool is_inner = x > 0 && x < 4 && y > 0 && y < 4;
                s.positions.push_back({x + (is_inner ? 0.3 * std::sin(5.0 * x + y) : 0),
                                       y + (is_inner ? 0.3 * std::cos(3.0 * x - y) : 0), 2});
            }
        for (std::uint32_t y = 0; y < 4; ++y)
            for (std::uint32_t x = 0; x < 4; ++x) {
                const std::uint32_t a = y * 5 + x, b = a + 1, c = b + 5, d = a + 5;
                if (scheme == Scheme::loop)
                    faces.insert(faces.end(), {{a, b, c}, {a, c, d}});
                else
                    faces.push_back({a, b, c, d});
            }
        s.faces = polygons(faces);
        s.pinned = {0, 4, 20, 24};  // two of the corners have two triangles, so that their boundary would be round
        const LimitSurface out = subdivide(s, context);
        double area = 0;
        const std::uint32_t c = out.corners_of_face;
        for (std::size_t i = 0; i < out.vertices.size(); i += c)
            for (std::uint32_t k = 2; k < c; ++k) {
                const dvec3 a = out.positions[out.vertices[i]];
                area +=
                    0.5 * cross(out.positions[out.vertices[i + k - 1]] - a, out.positions[out.vertices[i + k]] - a).z;
            }
        EXPECT_NEAR(area, 16, 1e-12);
        for (const dvec3 p : out.positions) EXPECT_EQ(p.z, 2);
        for (const dvec3 n : out.normals) EXPECT_NEAR(n.z, 1, 1e-15);
    }
}

/// The greatest angle between the normals at one level and those of the facets around the same points five levels on.
double worst_normal_deg(ControlSurface s) {
    Context context;
    s.level = 1;
    const LimitSurface coarse = subdivide(s, context);
    s.level = 6;
    const LimitSurface fine = subdivide(s, context);
    using Key = std::array<long long, 3>;
    const auto key = [](dvec3 p) {
        return Key{std::llround(p.x * 1e9), std::llround(p.y * 1e9), std::llround(p.z * 1e9)};
    };
    std::map<Key, std::map<std::uint32_t, dvec3>> facets;  // by place and sector
    for (const dvec3 p : coarse.positions) facets[key(p)];
    const std::uint32_t c = fine.corners_of_face;
    for (std::size_t i = 0; i < fine.vertices.size(); ++i) {
        const std::size_t face = i / c * c, k = i - face;
        const dvec3 p = fine.positions[fine.vertices[i]];
        const auto at = facets.find(key(p));
        if (at == facets.end()) continue;
        at->second[fine.normal_of[i]] += cross(fine.positions[fine.vertices[face + (k + 1) % c]] - p,
                                               fine.positions[fine.vertices[face + (k + c - 1) % c]] - p);
    }
    double worst = 0;
    for (std::size_t i = 0; i < coarse.vertices.size(); ++i) {
        double best = -1;
        for (const auto& [sector, sum] : facets[key(coarse.positions[coarse.vertices[i]])])
            best = std::max(best, dot(normalize_or(sum, {0, 0, 0}), coarse.normals[coarse.normal_of[i]]));
        worst = std::max(worst, std::acos(std::min(best, 1.0)) * 180 / pi);
    }
    return worst;
}

TEST(Subdivide, NormalsAreThoseThatEverFinerFacetsComeTo) {
    for (const Scheme scheme : {Scheme::catmull_clark, Scheme::loop}) {
        for (const int n : {3, 4, 5, 7}) EXPECT_LT(worst_normal_deg(disc(scheme, n, 2)), 2) << int(scheme) << " " << n;
        // On the boundary with one, two and three faces; with more the facets come to it too slowly to tell.
        for (const auto& [n, gap] : {std::pair(3, 2), std::pair(3, 1), std::pair(5, 3)})
            EXPECT_LT(worst_normal_deg(disc(scheme, n, 2, gap)), 2) << int(scheme) << " " << n << " " << gap;
    }
    EXPECT_LT(worst_normal_deg(disc(Scheme::loop, 5, 2, 2)), 2);
}

/// How far `left` is from an eigenvector of a matrix of rows, as a ratio.
double eigenvector_error(const std::vector<std::vector<double>>& matrix, const std::vector<double>& left) {
    std::vector<double> image(left.size(), 0);
    for (std::size_t row = 0; row < left.size(); ++row)
        for (std::size_t column = 0; column < left.size(); ++column) image[column] += left[row] * matrix[row][column];
    double dot = 0, square = 0, error = 0;
    for (std::size_t i = 0; i < left.size(); ++i) dot += left[i] * image[i], square += left[i] * left[i];
    for (std::size_t i = 0; i < left.size(); ++i) error = std::max(error, std::abs(image[i] - dot / square * left[i]));
    return error;
}

TEST(Subdivide, TheVectorAcrossACreaseIsAnEigenvectorOfTheRulesThere) {
    for (int k = 2; k <= 9; ++k) {
        // vertex, edges 0..k, and for Catmull-Clark the far corners of the faces 1..k
        const std::size_t n = std::size_t(k), edge = 1, far = n + 2;
        std::vector<std::vector<double>> loop(n + 2, std::vector<double>(n + 2, 0)),
            quads(2 * n + 2, std::vector<double>(2 * n + 2, 0));
        for (auto* m : {&loop, &quads}) {
            (*m)[0][0] = 0.75, (*m)[0][edge] = (*m)[0][edge + n] = 0.125;
            for (const std::size_t end : {edge, edge + n}) (*m)[end][0] = (*m)[end][end] = 0.5;
        }
        for (std::size_t i = 1; i < n; ++i) {
            loop[edge + i][0] = loop[edge + i][edge + i] = 0.375;
            loop[edge + i][edge + i - 1] = loop[edge + i][edge + i + 1] = 0.125;
            quads[edge + i][0] = quads[edge + i][edge + i] = 0.375;
            for (const std::size_t beside : {edge + i - 1, edge + i + 1, far + i - 1, far + i})
                quads[edge + i][beside] = 1.0 / 16;
        }
        for (std::size_t i = 0; i < n; ++i)
            for (const std::size_t corner : {std::size_t(0), edge + i, edge + i + 1, far + i})
                quads[far + i][corner] = 0.25;
        for (const bool is_loop : {true, false}) {
            const AcrossWeights w = is_loop ? loop_across_weights(k) : catmull_clark_across_weights(k);
            std::vector<double> left(is_loop ? n + 2 : 2 * n + 2, w.ends);
            for (std::size_t i = 1; i < n; ++i) left[edge + i] = w.edge * std::sin(double(i) * pi / k);
            for (std::size_t i = 0; i < n && !is_loop; ++i)
                left[far + i] = w.face * std::sin((double(i) + 0.5) * pi / k);
            left[0] = 0;
            for (std::size_t i = 1; i < left.size(); ++i) left[0] -= left[i];  // of differences from the vertex
            EXPECT_LT(eigenvector_error(is_loop ? loop : quads, left), 1e-14) << k;
        }
    }
}

TEST(Subdivide, ACreaseHasANormalForEachSide) {
    Context context;
    ControlSurface s = cube();
    s.creases = {{0, 1}, {1, 3}, {3, 2}, {2, 0}};  // around the side at -x
    s.level = 3;
    const LimitSurface out = subdivide(s, context);
    for (std::size_t i = 0; i < out.vertices.size() / 6; ++i) {  // the first of six control faces
        EXPECT_NEAR(out.positions[out.vertices[i]].x, -1, 1e-15);
        EXPECT_NEAR(out.normals[out.normal_of[i]].x, -1, 1e-15);  // flat to its rim
    }
    for (std::size_t i = out.vertices.size() / 6; i < out.vertices.size(); ++i)
        if (out.positions[out.vertices[i]].x < -1 + 1e-12) {
            EXPECT_GT(out.normals[out.normal_of[i]].x, -0.5);
        }
    s.creases = {};
    for (std::uint32_t a = 0; a < 8; ++a)
        for (std::uint32_t bit : {1u, 2u, 4u})
            if (!(a & bit)) s.creases.push_back({a, a | bit});
    for (const dvec3 p : limit(s, 3)) EXPECT_EQ(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 1);
    EXPECT_LT(worst_normal_deg(s), 1e-6);  // still a cube
}

TEST(Subdivide, ABoundaryIsTheCubicSplineOfItsVertices) {
    // A boundary does not know of the inside: (a + 4 b + c) / 6 is the limit, whatever the scheme
    ControlSurface s = disc(Scheme::loop, 6, 2);
    const auto points = limit(s, 2);
    for (std::uint32_t i = 0; i < 12; ++i) {
        const auto at = [&](std::uint32_t k) { return s.positions[13 + k % 12]; };
        EXPECT_LT(distance_to(points, (at(i) + at(i + 1) * 4.0 + at(i + 2)) / 6.0), 1e-14);
    }
    ControlSurface quad;
    quad.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    quad.faces = polygons({{0, 1, 2, 3}});
    EXPECT_LT(distance_to(limit(quad, 2), {0, 0, 0}), 1e-15);
    quad.sharpens_corners = false;
    EXPECT_LT(distance_to(limit(quad, 2), {1.0 / 6, 1.0 / 6, 0}), 1e-15);
    EXPECT_GT(distance_to(limit(quad, 2), {0, 0, 0}), 0.2);
}

// --- OpenSubdiv's own evaluation as the oracle

struct FarPoint {
    double x = 0, y = 0, z = 0;
    void Clear() { x = y = z = 0; }
    void AddWithWeight(const FarPoint& p, double w) { x += w * p.x, y += w * p.y, z += w * p.z; }
};

/// Limit points of the last level, in OpenSubdiv's order, which ours is too.
std::vector<FarPoint> far_limit(const ControlSurface& s) {
    namespace Far = OpenSubdiv::Far;
    namespace Sdc = OpenSubdiv::Sdc;
    std::vector<int> sizes, corners(s.faces.corners.begin(), s.faces.corners.end()), creases;
    for (std::uint32_t f = 0; f < s.faces.count(); ++f) sizes.push_back(int(s.faces.size(f)));
    for (const auto& [a, b] : s.creases) creases.insert(creases.end(), {int(a), int(b)});
    const std::vector<float> weights(s.creases.size(), float(s.sharpness));
    Far::TopologyDescriptor d;
    d.numVertices = int(s.positions.size());
    d.numFaces = int(sizes.size());
    d.numVertsPerFace = sizes.data();
    d.vertIndicesPerFace = corners.data();
    d.numCreases = int(weights.size());
    d.creaseVertexIndexPairs = creases.data();
    d.creaseWeights = weights.data();
    Sdc::Options rules;
    rules.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    const std::unique_ptr<Far::TopologyRefiner> refiner(
        Factory::Create(d, Factory::Options(s.scheme == Scheme::loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK, rules)));
    Far::TopologyRefiner::UniformOptions options(s.level);
    options.fullTopologyInLastLevel = true;
    refiner->RefineUniform(options);
    const Far::PrimvarRefinerReal<double> evaluate(*refiner);
    std::vector<FarPoint> points;
    for (const dvec3 p : s.positions) points.push_back({p.x, p.y, p.z});
    for (int level = 1; level <= s.level; ++level) {
        std::vector<FarPoint> next(std::size_t(refiner->GetLevel(level).GetNumVertices()));
        evaluate.Interpolate(level, points, next);
        points = next;
    }
    std::vector<FarPoint> out(points.size());
    evaluate.Limit(points, out);
    return out;
}

TEST(Subdivide, PointsAreThoseOfOpenSubdivsOwnEvaluationCreasesOfAnySharpnessIncluded) {
    for (const Scheme scheme : {Scheme::catmull_clark, Scheme::loop})
        for (const double sharpness : {0.0, 0.4, 1.0, 1.7, 2.5, 10.0})
            for (const int n : {3, 5, 6}) {
                ControlSurface s = disc(scheme, n, 3, n == 5 ? 1 : 0);
                s.level = 4;
                s.sharpness = sharpness;
                s.creases = {
                    {0, 1}, {0, 3}, {1, std::uint32_t(1 + 2 * n)}, {4, 5}};  // a crease with a dart, and one apart
                if (n == 6) s.creases.push_back({0, 5});                     // a corner
                const std::vector<FarPoint> want = far_limit(s);
                const std::vector<dvec3> got = limit(s, 4);
                ASSERT_EQ(want.size(), got.size());
                double worst = 0;
                for (std::size_t i = 0; i < got.size(); ++i)
                    worst = std::max(worst, length(got[i] - dvec3{want[i].x, want[i].y, want[i].z}));
                EXPECT_LT(worst, 1e-6) << int(scheme) << " " << sharpness << " " << n;
            }
}

TEST(Subdivide, ThreadsDoNotChangeABit) {
    ControlSurface s = disc(Scheme::catmull_clark, 7, 6, 1);
    s.level = 5;
    Context one({.threads = 1}), many({.threads = 8});
    const LimitSurface a = subdivide(s, one), b = subdivide(s, many);
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.normals, b.normals);
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.normal_of, b.normal_of);
}

// --- values

TEST(Subdivide, ValuesThatAreThePositionsComeOutAsThePositions) {
    Context context;
    ControlSurface s = disc(Scheme::catmull_clark, 5, 2);
    s.level = 2;
    s.creases = {{0, 1}, {0, 3}};
    s.sharpness = 1.5;
    ControlValues values{s.faces.corners, {}, ValueRule::smooth};
    for (const dvec3 p : s.positions) values.values.push_back({p.x, p.y, p.z, 1});
    const LimitSurface surface = subdivide(s, context);
    const LimitValues out = subdivide_values(s, values, context);
    EXPECT_EQ(out.corners, surface.vertices);
    for (std::size_t i = 0; i < out.values.size(); ++i) {
        EXPECT_EQ(out.values[i].xyz(), surface.positions[i]);
        EXPECT_NEAR(out.values[i].w, 1, 1e-15);
    }
}

TEST(Subdivide, ChartsEndWhereTheyEndedAndLinearValuesAreHalfway) {
    Context context;
    ControlSurface s = cube();
    s.level = 3;
    ControlValues charts;  // each side a unit square of its own
    for (std::uint32_t f = 0; f < 6; ++f)
        for (const dvec2 uv : {dvec2{0, 0}, dvec2{1, 0}, dvec2{1, 1}, dvec2{0, 1}}) {
            charts.corners.push_back(std::uint32_t(charts.values.size()));
            charts.values.push_back({uv.x, uv.y, double(f), 0});
        }
    const auto extent = [&](ValueRule rule) {
        charts.rule = rule;
        const LimitValues out = subdivide_values(s, charts, context);
        std::set<double> u;
        for (const dvec4 v : out.values) {
            u.insert(v.x);
            EXPECT_EQ(v.z, std::floor(v.z));  // charts do not mix
        }
        return u;
    };
    const std::set<double> linear = extent(ValueRule::linear);
    EXPECT_EQ(linear, extent(ValueRule::fixed_ends));  // a single quad: the same
    EXPECT_EQ(linear.size(), 9u);
    EXPECT_EQ(*linear.begin(), 0);
    EXPECT_EQ(*linear.rbegin(), 1);
    EXPECT_EQ(*extent(ValueRule::smooth).rbegin(), 1);  // corners of charts stay
    s.sharpens_corners = false;
    EXPECT_NEAR(*extent(ValueRule::smooth).rbegin(), 46.0 / 48,
                1e-15);  // the middle of a side of a closed cubic spline
    EXPECT_EQ(*extent(ValueRule::fixed_ends).rbegin(), 1);
}

TEST(Subdivide, FacesComeInTheOrderOfTheirControlFaces) {
    Context context;
    ControlSurface s = cube();
    s.faces = polygons({{0, 1, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}});
    for (std::uint32_t v = 0; v < 8; ++v) s.pinned.push_back(v);
    s.level = 3;
    EXPECT_EQ(fine_face_count(s.scheme, 3, s.faces), (5u * 4 + 2 * 3) * 16);
    const LimitSurface out = subdivide(s, context);
    ASSERT_EQ(out.vertices.size() / 4, fine_face_count(s.scheme, 3, s.faces));
    std::size_t face = 0;
    for (std::uint32_t f = 0; f < s.faces.count(); ++f) {
        std::set<std::array<double, 3>> corners;  // pinned: each control face's own are among its fine ones'
        for (std::size_t end = face + s.faces.size(f) * 16; face < end; ++face)
            for (std::size_t k = 0; k < 4; ++k) {
                const dvec3 p = out.positions[out.vertices[4 * face + k]];
                corners.insert({p.x, p.y, p.z});
            }
        for (std::uint32_t c = s.faces.first[f]; c < s.faces.first[f + 1]; ++c) {
            const dvec3 p = s.positions[s.faces.corners[c]];
            EXPECT_TRUE(corners.contains({p.x, p.y, p.z})) << f;
        }
    }
}

TEST(Subdivide, MoreFacesThanCanBeNumberedAreRefused) {
    Context context;
    ControlSurface s = disc(Scheme::loop, 500, 3);
    s.level = 10;
    EXPECT_THROW(subdivide(s, context), Error);
}

}  // namespace
}  // namespace rakelight::geometry
