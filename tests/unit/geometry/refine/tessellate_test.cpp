// SPDX-License-Identifier: Apache-2.0
#include "geometry/refine/tessellate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "math/linear.h"

namespace rakelight::geometry {
namespace {

using Point = std::tuple<double, double, double>;
Point key(dvec3 p) { return {p.x, p.y, p.z}; }

double area_of(const FineMesh& m) {
    double sum = 0;
    for (std::size_t i = 0; i < m.indices.size(); i += 3)
        sum += length(cross(m.places[m.indices[i + 1]] - m.places[m.indices[i]],
                            m.places[m.indices[i + 2]] - m.places[m.indices[i]])) /
               2;
    return sum;
}

/// How often each directed edge occurs in all meshes together.
std::map<std::pair<Point, Point>, int> edges_of(const Tessellation& t) {
    std::map<std::pair<Point, Point>, int> edges;
    for (const FineMesh& m : t.meshes)
        for (std::size_t i = 0; i < m.indices.size(); i += 3)
            for (std::size_t k = 0; k < 3; ++k)
                ++edges[{key(m.places[m.indices[i + k]]), key(m.places[m.indices[i + (k + 1) % 3]])}];
    return edges;
}

/// A tetrahedron of uneven edges, each face a mesh of its own with its own vertices.
std::vector<CoarseMesh> faces_of_tetrahedron() {
    const dvec3 p[4] = {{0, 0, 0}, {3.1, 0.2, 0.1}, {0.3, 1.7, -0.2}, {0.4, 0.5, 0.9}};
    std::vector<CoarseMesh> out;
    for (const auto& f : {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{1, 2, 3}, std::array{2, 0, 3}})
        out.push_back({{p[f[0]], p[f[1]], p[f[2]]}, {0, 1, 2}, {}});
    return out;
}

TEST(Tessellate, CutsEveryEdgeToTheWantedLengthAndStaysClosedAcrossMeshes) {
    Context context;
    for (const double edge : {1.0, 0.3, 0.11, 0.037}) {
        const Tessellation t = tessellate(faces_of_tetrahedron(), edge, 1u << 20, context);
        EXPECT_TRUE(t.is_complete);
        EXPECT_LE(t.longest_edge, edge);
        EXPECT_GT(t.longest_edge, edge / 2);
        for (const auto& [e, count] : edges_of(t)) {
            EXPECT_EQ(count, 1);
            EXPECT_GT(std::sqrt(std::pow(std::get<0>(e.first) - std::get<0>(e.second), 2) +
                                std::pow(std::get<1>(e.first) - std::get<1>(e.second), 2) +
                                std::pow(std::get<2>(e.first) - std::get<2>(e.second), 2)),
                      0.0);
        }
        const auto edges = edges_of(t);
        for (const auto& [e, count] : edges) ASSERT_TRUE(edges.contains({e.second, e.first}));
    }
}

TEST(Tessellate, KeepsTheSurfaceTheWindingAndTheSources) {
    Context context;
    const std::vector<CoarseMesh> coarse = faces_of_tetrahedron();
    const Tessellation whole = tessellate(coarse, 100, 1000, context),
                       fine = tessellate(coarse, 0.1, 1u << 20, context);
    for (std::size_t m = 0; m < coarse.size(); ++m) {
        EXPECT_EQ(whole.meshes[m].indices, coarse[m].indices);
        EXPECT_NEAR(area_of(fine.meshes[m]), area_of(whole.meshes[m]), 1e-12);
        EXPECT_EQ(fine.meshes[m].source_triangle.size() * 3, fine.meshes[m].indices.size());
        const FineMesh& f = fine.meshes[m];
        const dvec3 n = cross(coarse[m].places[1] - coarse[m].places[0], coarse[m].places[2] - coarse[m].places[0]);
        for (std::size_t i = 0; i < f.indices.size(); i += 3)
            ASSERT_GT(dot(n, cross(f.places[f.indices[i + 1]] - f.places[f.indices[i]],
                                   f.places[f.indices[i + 2]] - f.places[f.indices[i]])),
                      0);
        for (std::size_t v = 0; v < f.middle_of.size(); ++v) {
            const auto [a, b] = f.middle_of[v];
            ASSERT_LT(b, 3 + v);
            ASSERT_TRUE(f.places[3 + v] == (f.places[a] + f.places[b]) * 0.5);
        }
    }
}

TEST(Tessellate, ACoarseNeighborIsCutAlongTheBorderAlone) {
    Context context;
    const dvec3 a{0, 0, 0}, b{1, 0, 0}, c{0.5, 1, 0}, d{0.5, -1, 0};
    const std::vector<CoarseMesh> meshes = {{{a, b, c}, {0, 1, 2}, {}}, {{b, a, d}, {0, 1, 2}, {1, 1, 0}}};
    const Tessellation t = tessellate(meshes, 0.26, 1000, context);
    EXPECT_EQ(t.meshes[1].indices.size() / 3, 4u);  // the border in four
    const auto edges = edges_of(t);
    for (int i = 0; i < 4; ++i) {
        const Point p{i * 0.25, 0, 0}, q{(i + 1) * 0.25, 0, 0};
        EXPECT_TRUE(edges.contains({p, q}) && edges.contains({q, p})) << i;
    }
}

TEST(Tessellate, StopsForAllMeshesBeforeTheLimit) {
    Context context;
    const Tessellation t = tessellate(faces_of_tetrahedron(), 1e-3, 500, context);
    EXPECT_FALSE(t.is_complete);
    std::size_t triangles = 0;
    for (const FineMesh& m : t.meshes) triangles += m.indices.size() / 3;
    EXPECT_LE(triangles, 500u);
    EXPECT_GT(triangles, 100u);
    for (const auto& edges = edges_of(t); const auto& [e, count] : edges)
        ASSERT_TRUE(edges.contains({e.second, e.first}));
}

TEST(Tessellate, IsTheSameForAnyNumberOfThreads) {
    Context one({.threads = 1}), four({.threads = 4});
    const Tessellation a = tessellate(faces_of_tetrahedron(), 0.05, 1u << 20, one),
                       b = tessellate(faces_of_tetrahedron(), 0.05, 1u << 20, four);
    for (std::size_t m = 0; m < 4; ++m) {
        EXPECT_EQ(a.meshes[m].indices, b.meshes[m].indices);
        EXPECT_TRUE(a.meshes[m].places == b.meshes[m].places);
    }
}

TEST(Tessellate, NamedEdgesAreHalvedOnceAndOtherTrianglesStay) {
    // two squares of two meshes with a common edge: x = 1
    std::vector<FineMesh> meshes = {
        uncut({.places = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, .indices = {0, 1, 2, 0, 2, 3}}),
        uncut({.places = {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}}, .indices = {0, 1, 2, 0, 2, 3}})};
    const auto is_common = [](dvec3 a, dvec3 b) { return a.x == 1 && b.x == 1; };
    Context context({.threads = 2});
    const std::vector<FineMesh> before = meshes;
    EXPECT_FALSE(halve_edges(meshes, is_common, 5, context)) << "there would be six";
    EXPECT_EQ(meshes[0].indices, before[0].indices);
    EXPECT_EQ(meshes[1].places.size(), 4u);
    ASSERT_TRUE(halve_edges(meshes, is_common, 6, context));
    for (const FineMesh& mesh : meshes) {
        ASSERT_EQ(mesh.places.size(), 5u);
        EXPECT_TRUE((mesh.places[4] == dvec3{1, 0.5, 0}));
    }
    EXPECT_EQ(meshes[0].source_triangle, (std::vector<std::uint32_t>{0, 0, 1}));
    EXPECT_EQ(meshes[1].source_triangle, (std::vector<std::uint32_t>{0, 1, 1}));
    EXPECT_TRUE(std::equal(meshes[0].indices.begin() + 6, meshes[0].indices.end(), before[0].indices.begin() + 3));
    ASSERT_TRUE(halve_edges(
        meshes, [](dvec3, dvec3) { return false; }, 6, context));
    EXPECT_EQ(meshes[0].indices.size(), 9u);
}

}  // namespace
}  // namespace rakelight::geometry
