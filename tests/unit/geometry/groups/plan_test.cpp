// SPDX-License-Identifier: Apache-2.0
// The two steps apart: a plan serves other positions of the same meshes.
#include <gtest/gtest.h>

#include "support/thrown_error.h"
#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

TEST(AttributePlan, TwoStepsEqualTheOne) {
    for (const double crease : {30.0, 60.0, 180.0}) {
        auto parts = cut_at_random(make_torus(20, 10), 3, 1);
        parts.push_back(make_cube());
        AttributeOptions options;
        options.crease_angle_rad = radians(crease);
        Context context({.threads = 2});
        const auto meshes = views(parts);
        const auto two = accumulate(group(meshes, options, context), meshes, context), one = compute(parts, options);
        EXPECT_LE(largest_difference(one, two), float_rounding);
    }
}

TEST(AttributePlan, OneThatWasMovedAwayIsRefused) {
    const std::vector<Shape> parts = {make_cube()};
    Context context;
    AttributePlan plan = group(views(parts), {}, context);
    const AttributePlan taken = std::move(plan);
    for (const AttributePlan& empty : {plan, AttributePlan(nullptr)}) {  // NOLINT(bugprone-use-after-move)
        EXPECT_EQ(error_of([&] { accumulate(empty, views(parts), context); }).code(), ErrorCode::usage);
        EXPECT_EQ(error_of([&] { regroup(empty, views(parts), {}, context); }).code(), ErrorCode::usage);
    }
    EXPECT_EQ(accumulate(taken, views(parts), context).size(), 1u);
}

TEST(AttributePlan, GroupsOfThePoseThatWasGroupedHoldForOthers) {
    // Flat when grouped; bent by 90 degrees after: the common edge stays smooth though it exceeds the crease angle.
    auto parts = make_hinge(0);
    AttributeOptions options;
    options.crease_angle_rad = radians(30);
    Context context({.threads = 2});
    const AttributePlan plan = group(views(parts), options, context);
    parts[1].positions = make_hinge(radians(90))[1].positions;
    const auto out = accumulate(plan, views(parts), context);
    EXPECT_EQ(out[0].normals[0], out[1].normals[0]);
    EXPECT_NEAR(degrees(angle_between(out[0].normals[0], vec3{0, 1, 0})), 45, 1e-3);
    EXPECT_NE(compute(parts, options)[0].normals[0], compute(parts, options)[1].normals[0]);
}

TEST(AttributePlan, MovedVerticesThatCancelKeepTheirOwnSide) {
    auto parts = make_hinge(0);
    Context context({.threads = 1});
    const AttributePlan plan = group(views(parts), published(), context);
    parts[1].positions = make_hinge(pi)[1].positions;
    parts[1].positions[2] = parts[0].positions[2];
    parts[1].positions[3] = parts[0].positions[3];
    const auto out = accumulate(plan, views(parts), context);
    EXPECT_EQ(out[0].normals[0], (vec3{0, 1, 0}));
    EXPECT_EQ(out[1].normals[0], (vec3{0, -1, 0}));
}

TEST(AttributePlan, OtherMeshesAreRefused) {
    Context context({.threads = 1});
    const std::vector<Shape> cube{make_cube()}, sphere{make_sphere(4, 3)};
    const AttributePlan plan = group(views(cube), {}, context);
    EXPECT_THROW(accumulate(plan, views(sphere), context), Error);
    EXPECT_THROW(accumulate(plan, views({make_cube(), make_cube()}), context), Error);
    Shape textured = make_cube();
    textured.texcoords.resize(8);
    EXPECT_THROW(accumulate(plan, views({textured}), context), Error);
}

TEST(AttributePlan, MemoryOfSplitVerticesCounts) {
    const Shape sphere =
        make_sphere(100, 100);  // 10,201 vertices; flat it has 60,000, each with 92 bytes of sums and results
    const std::vector<AttributeMesh> meshes{sphere.view()};
    constexpr std::uint64_t limit = 4'500'000;
    Context smooth({.threads = 1, .max_memory = limit});
    EXPECT_NO_THROW(compute_attributes(meshes, {}, smooth));
    Context flat({.threads = 1, .max_memory = limit});
    EXPECT_THROW(compute_attributes(meshes, {.scope = Scope::face}, flat), Error);
    AttributeOptions options;
    options.scope = Scope::face;
    Context roomy({.threads = 1});
    const AttributePlan plan = group(meshes, options, roomy);
    EXPECT_THROW(accumulate(plan, meshes, flat), Error);
}

}  // namespace
}  // namespace rakelight::test
