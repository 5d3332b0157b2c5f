// SPDX-License-Identifier: Apache-2.0
#include "geometry/refine/polygon_loops.h"

#include <gtest/gtest.h>

namespace rakelight::geometry {
namespace {

using Numbers = std::vector<std::uint32_t>;

TEST(PolygonLoops, TrianglesWithEqualNumbersAreOnePolygonAgain) {
    // a quad, a triangle, a pentagon cut by ears
    const Numbers indices{0, 1, 2, 0, 2, 3, /**/ 3, 2, 4, /**/ 5, 6, 7, 8, 9, 5, 5, 7, 8};
    const PolygonLoops out = polygon_loops(indices, Numbers{0, 0, 2, 3, 3, 3});
    ASSERT_EQ(out.faces.count(), 3u);
    EXPECT_EQ(out.faces.corners, (Numbers{0, 1, 2, 3, 3, 2, 4, 5, 6, 7, 8, 9}));
    EXPECT_EQ(out.first_triangle, (Numbers{0, 2, 3, 6}));
}

TEST(PolygonLoops, WithoutNumbersAllAreTriangles) {
    const Numbers indices{0, 1, 2, 0, 2, 3};
    const PolygonLoops out = polygon_loops(indices, {});
    EXPECT_EQ(out.faces.corners, indices);
    EXPECT_EQ(out.first_triangle, (Numbers{0, 1, 2}));
}

TEST(PolygonLoops, WhatIsNotOneSimpleLoopStaysTriangles) {
    const Numbers two_apart{0, 1, 2, 3, 4, 5};
    const Numbers at_a_point{0, 1, 2, 0, 3, 4};
    const Numbers the_same_twice{0, 1, 2, 0, 1, 2};
    const Numbers back_to_back{0, 1, 2, 2, 1, 0};
    const Numbers turned{0, 1, 2, 1, 2, 3};  // along the shared edge the same way
    const Numbers no_area{0, 0, 1, 0, 1, 2};
    for (const Numbers& indices : {two_apart, at_a_point, the_same_twice, back_to_back, turned, no_area})
        EXPECT_EQ(polygon_loops(indices, Numbers{7, 7}).faces.corners, indices);
}

}  // namespace
}  // namespace rakelight::geometry
