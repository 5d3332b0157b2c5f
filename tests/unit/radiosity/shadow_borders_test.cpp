// SPDX-License-Identifier: Apache-2.0
// Which elements are cut finer.
#include <gtest/gtest.h>

#include "radiosity/cut.h"
#include "radiosity/shadow_borders.h"
#include "unit/radiosity/box_scene.h"

namespace rakelight::radiosity {
namespace {

struct TwoSquares {
    TwoSquares() : context({.threads = 1}) {
        scene.materials = {diffuse({1, 1, 1})};
        test::add_object(scene, test::square_mesh(0));
        test::add_object(scene, test::square_mesh(0), translation(dvec3{2, 0, 0}));
        parts = lit_parts(scene);
        meshes = placed_meshes(scene, parts, context);
        const ColorMaps colors(scene, {true}, context);
        elements = make_elements(scene, parts, meshes, colors, context);
    }
    EdgeSet borders(const std::vector<dvec3>& light, std::uint64_t most = 100) const {
        return shadow_borders(parts, meshes, elements, light, 0.01, most);
    }
    Scene scene;
    Context context;
    std::vector<Part> parts;
    std::vector<geometry::FineMesh> meshes;
    Elements elements;  // two of each square
};

const dvec3 bright{1, 1, 1}, dark{0, 0, 0};

TEST(ShadowBorders, EvenLightIsNotCut) { EXPECT_TRUE(TwoSquares().borders(std::vector<dvec3>(4, bright)).empty()); }

TEST(ShadowBorders, NeighborsOfTwoObjectsAreCompared) {
    const TwoSquares s;
    const EdgeSet edges = s.borders({bright, bright, dark, dark});
    EXPECT_TRUE(edges.holds({1, -1, 0}, {1, 1, 0}));  // the common edge, by either order
    EXPECT_TRUE(edges.holds({1, 1, 0}, {1, -1, 0}));
    EXPECT_FALSE(edges.holds({-1, -1, 0}, {-1, 1, 0}));  // of a triangle that has no dark neighbor
}

TEST(ShadowBorders, ACreaseIsNoShadow) {
    TwoSquares s;
    for (Element& e : s.elements.list)
        if (e.center.x > 1) e.normal = {-0.8, 0, 0.6};
    EXPECT_TRUE(s.borders({bright, bright, dark, dark}).empty());
}

TEST(ShadowBorders, OfEqualDifferencesTheLargerElementsComeFirst) {
    TwoSquares s;
    s.elements.list[0].area = s.elements.list[1].area = 1;  // of 2, those of the second square
    const std::vector<dvec3> light{bright, dark, bright, dark};
    const EdgeSet edges = s.borders(light, 10);
    EXPECT_TRUE(edges.holds({1, -1, 0}, {3, 1, 0}));
    EXPECT_FALSE(edges.holds({-1, -1, 0}, {1, 1, 0}));
    EXPECT_TRUE(s.borders(light, 100).holds({-1, -1, 0}, {1, 1, 0}));
}

TEST(ShadowBorders, KeepsWithinTheElements) {
    const TwoSquares s;
    std::vector<geometry::FineMesh> cut = s.meshes;
    Context context;
    for (const std::uint64_t most : {4u, 6u, 9u, 20u}) {
        cut = s.meshes;
        const EdgeSet edges = s.borders({bright, dark, bright, dark}, most);
        ASSERT_TRUE(geometry::halve_edges(
            cut, [&](dvec3 a, dvec3 b) { return edges.holds(a, b); }, 100, context));
        EXPECT_LE(count_sides(s.parts, cut), most);
    }
    EXPECT_TRUE(s.borders({bright, dark, bright, dark}, 4).empty());
    EXPECT_FALSE(s.borders({bright, dark, bright, dark}, 20).empty());
}

}  // namespace
}  // namespace rakelight::radiosity
