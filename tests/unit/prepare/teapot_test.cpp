// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include <rakelight/base/error.h>
#include <rakelight/scene/scene_queries.h>
#include <rakelight/scene/validate.h>

#include "math/linear.h"
#include "prepare/prepare_scene.h"
#include "prepare/shapes/teapot.h"
#include "scene/drawn_vertices.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

using Point = std::tuple<float, float, float>;
Point key(vec3 p) { return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; }  // -0 becomes 0

const Mesh& part(const Scene& scene, const std::string& name) {
    for (const Mesh& mesh : scene.meshes)
        if (mesh.name == name) return mesh;
    ADD_FAILURE() << "no part " << name;
    return scene.meshes.front();
}

std::array<vec3, 3> triangle(const Mesh& mesh, std::size_t t) {
    return {mesh.positions[mesh.indices[3 * t]], mesh.positions[mesh.indices[3 * t + 1]],
            mesh.positions[mesh.indices[3 * t + 2]]};
}

/// How often each directed edge occurs, by position; a closed sheet has every edge once each way.
std::map<std::pair<Point, Point>, int> directed_edges(const Scene& scene) {
    std::map<std::pair<Point, Point>, int> edges;
    for (const Mesh& mesh : scene.meshes)
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
            const auto p = triangle(mesh, t);
            for (std::size_t k = 0; k < 3; ++k) ++edges[{key(p[k]), key(p[(k + 1) % 3])}];
        }
    return edges;
}

TEST(Teapot, HasSixNamedObjectsOfOneClassicalMaterial) {
    const Scene scene = make_teapot();
    EXPECT_NO_THROW(validate(scene));
    const char* names[] = {"rim", "body", "handle", "spout", "lid", "bottom"};
    ASSERT_EQ(scene.nodes.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(scene.nodes[i].name, names[i]);
        EXPECT_EQ(scene.nodes[i].meshes, std::vector<std::uint32_t>{std::uint32_t(i)});
        EXPECT_TRUE(scene.meshes[i].normals.empty());
    }
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].model, MaterialModel::classical);
}

TEST(Teapot, HasTwoTrianglesAQuadAndOneAtThePoles) {
    for (const int n : {1, 2, 7, 10, 33}) {
        const auto quads = std::uint64_t(n) * n;
        const Scene scene = make_teapot(n);
        EXPECT_EQ(triangle_count(scene), 32 * 2 * quads - 8 * std::uint64_t(n)) << n;
        EXPECT_EQ(part(scene, "rim").triangle_count(), 4 * 2 * quads);
        EXPECT_EQ(part(scene, "body").triangle_count(), 8 * 2 * quads);
        EXPECT_EQ(part(scene, "bottom").triangle_count(), 4 * 2 * quads - 4 * std::uint64_t(n));
    }
}

TEST(Teapot, RefusesDivisionsOutsideItsRange) {
    for (const int n : {1, 9}) {
        MemoryBudget memory;
        std::uint64_t held = 0;
        const Scene scene = make_teapot(n, &memory);
        for (const Mesh& mesh : scene.meshes) held += mesh.positions.size() * 20 + mesh.indices.size() * 4;
        EXPECT_EQ(memory.charged(), held) << n;
    }
    EXPECT_THROW(make_teapot(0), Error);
    EXPECT_THROW(make_teapot(-3), Error);
    EXPECT_THROW(make_teapot(257), Error);
    EXPECT_EQ(triangle_count(make_teapot(256)), 32ull * 2 * 65536 - 8 * 256);
}

TEST(Teapot, HasNoTriangleWithoutAreaAndNoStrayVertex) {
    for (const int n : {2, 3, 5, 10, 64}) {  // with 1 the spout's mouth is flat: all its corners lie on a line
        const Scene scene = make_teapot(n);
        for (const Mesh& mesh : scene.meshes) {
            std::set<std::uint32_t> used(mesh.indices.begin(), mesh.indices.end());
            EXPECT_EQ(used.size(), mesh.positions.size()) << mesh.name;
            for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
                const auto p = triangle(mesh, t);
                ASSERT_TRUE(is_finite(p[0]) && is_finite(p[1]) && is_finite(p[2]));
                const dvec3 a = cast<double>(p[0]), normal = cross(cast<double>(p[1]) - a, cast<double>(p[2]) - a);
                ASSERT_GT(length(normal), 0) << mesh.name << " triangle " << t << " of " << n;
            }
        }
    }
}

TEST(Teapot, IsWatertightToTheBitButForItsSixOpenEnds) {
    // Open: the rim's inner edge and the lid's edge (4 patches each), both ends of handle and spout (2 patches an end).
    for (const int n : {2, 3, 10, 37}) {  // with 1 the two halves of a tube coincide
        const auto edges = directed_edges(make_teapot(n));
        int open = 0;
        for (const auto& [edge, count] : edges) {
            ASSERT_EQ(count, 1) << "an edge runs twice the same way";
            if (!edges.contains({edge.second, edge.first})) ++open;
        }
        EXPECT_EQ(open, 16 * n) << n;
    }
}

/// The vertices of all patches of a teapot, in its order; of the pole's row all columns are the pole.
class PatchGrids {
public:
    PatchGrids(const Scene& scene, int n) : n_(n) {
        for (const Mesh& mesh : scene.meshes)
            for (std::size_t first = 0; first < mesh.positions.size();) {
                const bool pole = mesh.texcoords[0][first].x > 0;
                std::vector<dvec3>& grid = grids_.emplace_back();
                for (int c = 0; c <= n; ++c)
                    grid.push_back(cast<double>(mesh.positions[first + std::size_t(pole ? 0 : c)]));
                first += std::size_t(pole ? n : n + 1);
                for (int k = 0; k < n * (n + 1); ++k) grid.push_back(cast<double>(mesh.positions[first++]));
            }
    }

    std::size_t patches() const { return grids_.size(); }
    dvec3 vertex(std::size_t patch, int row, int column) const {
        return grids_[patch][std::size_t(row * (n_ + 1) + column)];
    }
    /// On the triangle that a place of the patch falls into; u and v from 0 to 1.
    dvec3 on_facet(std::size_t patch, double v, double u) const {
        const int row = std::min(int(v * n_), n_ - 1), column = std::min(int(u * n_), n_ - 1);
        const double a = v * n_ - row, b = u * n_ - column;
        const dvec3 first = vertex(patch, row, column), last = vertex(patch, row + 1, column + 1);
        return a > b ? first * (1 - a) + vertex(patch, row + 1, column) * (a - b) + last * b
                     : first * (1 - b) + vertex(patch, row, column + 1) * (b - a) + last * a;
    }

private:
    int n_;
    std::vector<std::vector<dvec3>> grids_;
};

/// [m] farthest that a facet is from the patch at the same u, v, at 210 x 210 places of each; their vertices lie on it.
double chordal_error(int divisions) {
    constexpr int places = 210;
    static const PatchGrids exact(make_teapot(places), places);
    const PatchGrids facets(make_teapot(divisions), divisions);
    EXPECT_EQ(facets.patches(), 32u);
    double most = 0;
    for (std::size_t p = 0; p < 32; ++p)
        for (int row = 0; row <= places; ++row)
            for (int column = 0; column <= places; ++column)
                most = std::max(most, length(facets.on_facet(p, double(row) / places, double(column) / places) -
                                             exact.vertex(p, row, column)));
    return most;
}

TEST(Teapot, NoPointOfAFacetIsFartherFromItsPatchThanTheTolerance) {
    constexpr double rounding = 3e-7;  // of positions as floats
    for (const double tolerance : {0.05, 0.01, 0.002, 0.0004}) {
        const int n = teapot_divisions(tolerance);
        const double error = chordal_error(n);
        EXPECT_LE(error, tolerance + rounding) << n;
        EXPECT_GT(error, 0.3 * tolerance) << n << " divisions are many more than that takes";
    }
}

TEST(Teapot, IsAsWatertightByToleranceAsByDivisions) {
    for (const double tolerance : {0.3, 0.02, 0.002}) {
        const int n = teapot_divisions(tolerance);
        const auto edges = directed_edges(make_teapot(n));
        const auto open = std::count_if(edges.begin(), edges.end(), [&](const auto& e) {
            EXPECT_EQ(e.second, 1);
            return !edges.contains({e.first.second, e.first.first});
        });
        EXPECT_EQ(open, 16 * n) << tolerance;
    }
}

TEST(Teapot, ATenthOfTheToleranceTakesThreeTimesTheDivisionsUpTo256) {
    EXPECT_EQ(teapot_divisions(100), 2);
    EXPECT_NEAR(double(teapot_divisions(1e-4)) / teapot_divisions(1e-3), std::sqrt(10.0), 0.1);
    EXPECT_THROW(teapot_divisions(1e-7), Error);
}

TEST(Teapot, PartsMeetInExactlyEqualPositions) {
    const int n = 10;
    const Scene scene = make_teapot(n);
    const auto common = [&](const char* a, const char* b) {
        std::set<Point> of_a, both;
        for (const vec3& p : part(scene, a).positions) of_a.insert(key(p));
        for (const vec3& p : part(scene, b).positions)
            if (of_a.contains(key(p))) both.insert(key(p));
        return both.size();
    };
    EXPECT_EQ(common("rim", "body"), 4u * n);
    EXPECT_EQ(common("body", "bottom"), 4u * n);
    EXPECT_EQ(common("handle", "body"), 1u) << "the lower end of the handle touches the body in one corner";
    EXPECT_EQ(common("lid", "rim"), 0u) << "there is a gap";
}

TEST(Teapot, FacesOutward) {
    const Scene scene = make_teapot(8);
    // Away from the axis or from the middle of the tube, part by part.
    for (const char* name : {"body", "lid", "bottom", "rim"}) {
        const Mesh& mesh = part(scene, name);
        double outward = 0, area = 0;
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
            const auto p = triangle(mesh, t);
            const vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
            const vec3 center = (p[0] + p[1] + p[2]) / 3.0f;
            const vec3 inside = std::string(name) == "rim" ? vec3{0, 0.5f, 0} : vec3{0, 0.4f, 0};
            outward += dot(normal, center - inside);
            area += length(normal);
        }
        EXPECT_GT(outward, 0.1 * area) << name;
    }
    for (const char* name : {"handle", "spout"}) {  // mirror images in z: the half at z > 0 faces +z
        const Mesh& mesh = part(scene, name);
        double outward = 0;
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
            const auto p = triangle(mesh, t);
            const float z = (p[0].z + p[1].z + p[2].z) / 3;
            outward += double(cross(p[1] - p[0], p[2] - p[0]).z) * (z > 0 ? 1 : -1);
        }
        EXPECT_GT(outward, 0.01) << name;
    }
}

TEST(Teapot, StandsOneHighOnTheGroundWithTheSpoutToTheRight) {
    const Bounds b = world_bounds(make_teapot(16));
    EXPECT_NEAR(b.low.y, 0, 1e-6);
    EXPECT_NEAR(b.high.y, 1, 1e-6);
    EXPECT_NEAR(b.low.z, -b.high.z, 1e-6);
    EXPECT_GT(b.high.x, -b.low.x);
}

TEST(Teapot, HasPatchCoordinatesThatAreUprightAndNotMirrored) {
    const Scene scene = make_teapot(6);
    for (const Mesh& mesh : scene.meshes) {
        ASSERT_EQ(mesh.texcoords.size(), 1u);
        const Block<vec2>& uv = mesh.texcoords[0];
        for (const vec2& c : uv) EXPECT_TRUE(c.x >= 0 && c.x <= 1 && c.y >= 0 && c.y <= 1);
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
            const vec2 a = uv[mesh.indices[3 * t]], b = uv[mesh.indices[3 * t + 1]], c = uv[mesh.indices[3 * t + 2]];
            const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
            ASSERT_LT(area, 0) << mesh.name << ": counter-clockwise seen with v down is negative";
        }
    }
    const Mesh& body = part(scene, "body");
    for (std::size_t v = 0; v + 1 < body.positions.size(); ++v)
        if (body.texcoords[0][v].y == 0 && body.texcoords[0][v].x == 0) {
            EXPECT_GT(body.positions[v].y, body.positions[v + 7 * 6].y) << "v runs down";
        }
}

TEST(Teapot, BecomesSmoothOverItsPartsWhenPrepared) {
    Context context;
    const Scene scene = prepare_scene(make_teapot(10), {}, context);
    std::map<Point, vec3> rim;
    for (std::size_t v = 0; v < part(scene, "rim").positions.size(); ++v)
        if (part(scene, "rim").texcoords[0][v].y == 1)
            rim[key(part(scene, "rim").positions[v])] = part(scene, "rim").normals[v];
    int met = 0;
    const Mesh& body = part(scene, "body");
    for (std::size_t v = 0; v < body.positions.size(); ++v) {
        const auto at = rim.find(key(body.positions[v]));
        if (at == rim.end()) continue;
        ++met;
        EXPECT_EQ(at->second, body.normals[v]);
    }
    EXPECT_EQ(met, 4 * 11) << "each of the four patches has 11 vertices on the border";
}

}  // namespace
}  // namespace rakelight
