// SPDX-License-Identifier: Apache-2.0
#include "geometry/faults/normal_sides.h"

#include <gtest/gtest.h>

#include "unit/geometry/folded.h"

namespace rakelight::test {
namespace {

using geometry::NormalSides;

std::vector<NormalSides> sides_of(const std::vector<Shape>& shapes, int threads = 1) {
    Context context({.threads = threads});
    return geometry::find_normal_sides(views(shapes), context);
}

Shape round_sphere() {
    Shape s = make_sphere(24, 12);
    s.normals = s.positions;
    return s;
}

void turn(Shape& s, std::size_t triangle) { std::swap(s.indices[3 * triangle + 1], s.indices[3 * triangle + 2]); }

TEST(NormalSides, AveragedNormalsAroundAFoldLeaveTheWindingItsSay) {
    for (const CornerWeight weight :
         {CornerWeight::uniform, CornerWeight::area, CornerWeight::angle, CornerWeight::angle_area}) {
        int against = 0;
        for (unsigned seed = 1; seed <= 5; ++seed) {
            const std::vector<Shape> whole = smoothed({make_crumpled_sheet(seed)}, weight),
                                     parts = smoothed(in_parts(make_crumpled_sheet(seed)), weight);
            against += count_against_own(whole[0]);
            EXPECT_EQ(sides_of(whole), (std::vector<NormalSides>(1)));
            EXPECT_EQ(sides_of(parts), (std::vector<NormalSides>(5)));
        }
        EXPECT_GT(against, 0) << "or this shows nothing";
    }
}

TEST(NormalSides, TrianglesThatAFileWindsWronglyAreFound) {
    Shape sphere = round_sphere();
    for (const std::size_t t : {100u, 101u, 102u, 333u}) turn(sphere, t);
    const std::vector<NormalSides> sides = sides_of({sphere});
    ASSERT_EQ(sides[0].against.size(), sphere.indices.size() / 3);
    for (std::size_t t = 0; t < sides[0].against.size(); ++t)
        EXPECT_EQ(sides[0].is_against(t), (t >= 100 && t <= 102) || t == 333) << t;
}

TEST(NormalSides, SoTheyAreWhereTheNormalsWereAveragedOverThem) {
    Shape sphere = make_sphere(24, 12);
    turn(sphere, 222);
    const std::vector<NormalSides> sides = sides_of(smoothed({sphere}, CornerWeight::angle));
    ASSERT_FALSE(sides[0].against.empty());
    for (std::size_t t = 0; t < sides[0].against.size(); ++t) EXPECT_EQ(sides[0].is_against(t), t == 222) << t;
}

TEST(NormalSides, AMeshThatIsInsideOutIsSoAsAWhole) {
    Shape tube = make_cylinder(24, 4);
    for (const vec3& p : tube.positions) tube.normals.push_back({p.x, 0, p.z});
    Shape other = tube;
    for (std::size_t t = 0; t < tube.indices.size() / 3; ++t) turn(tube, t);
    other.object = 1;
    other.to_world[3] = dvec4{5, 0, 0, 1};
    const std::vector<NormalSides> sides = sides_of({tube, other});
    EXPECT_EQ(sides[0], (NormalSides{true, {}}));
    EXPECT_EQ(sides[1], NormalSides{});
}

TEST(NormalSides, AMirroredHalfGoesOnTheSurfaceOfTheOther) {
    // A folded sheet and its mirror image beside it, of one mesh: their common border is smooth.
    Shape left = make_crumpled_sheet(3);
    for (vec3& p : left.positions) p.x = p.x > 0.93f ? 1.0f : p.x;
    Shape right = left;
    right.object = 1;
    right.to_world[0] = dvec4{-1, 0, 0, 0};
    right.to_world[3] = dvec4{2, 0, 0, 1};
    const std::vector<Shape> halves = smoothed({left, right}, CornerWeight::uniform);
    ASSERT_GT(count_against_own(halves[0]), 0);
    EXPECT_EQ(sides_of(halves), (std::vector<NormalSides>(2)));
}

TEST(NormalSides, AreTheSameForAnyNumberOfThreadsAndLengthOfNormals) {
    std::vector<Shape> parts = smoothed(in_parts(make_crumpled_sheet(9)), CornerWeight::angle);
    for (std::size_t t = 3; t < 40; t += 7) turn(parts[1], t);
    const std::vector<NormalSides> one = sides_of(parts, 1);
    ASSERT_FALSE(one[1].against.empty());
    EXPECT_EQ(sides_of(parts, 4), one);
    for (vec3& n : parts[2].normals) n = n * 7.5f;
    EXPECT_EQ(sides_of(parts, 2)[1], one[1]);
}

}  // namespace
}  // namespace rakelight::test
