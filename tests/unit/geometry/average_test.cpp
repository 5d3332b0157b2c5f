// SPDX-License-Identifier: Apache-2.0
// Values of faces as values of vertices: smooth where normals are, sharp at creases.
#include <gtest/gtest.h>

#include "support/thrown_error.h"
#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

using Values = std::vector<std::vector<vec3>>;

std::vector<std::vector<vec3>> averaged(const std::vector<Shape>& parts, const Values& values,
                                        const AttributeOptions& options, int threads = 2) {
    Context context({.threads = threads});
    std::vector<std::span<const vec3>> spans(values.begin(), values.end());
    const auto meshes = views(parts);
    return average(group(meshes, options, context), meshes, spans, context);
}

Values faces_of(const std::vector<Shape>& parts, const auto& value) {
    Values out;
    for (std::size_t m = 0; m < parts.size(); ++m) {
        out.emplace_back();
        for (std::size_t t = 0; t < parts[m].indices.size() / 3; ++t) out[m].push_back(value(m, t));
    }
    return out;
}

TEST(Average, AConstantStaysThatConstantToTheBit) {
    const vec3 constant{0.1f, 1e-30f, 12345.678f};
    auto parts = cut_at_random(make_torus(20, 10), 3, 1);
    parts.push_back(make_cube());
    const Values values = faces_of(parts, [&](std::size_t, std::size_t) { return constant; });
    for (const CornerWeight weight :
         {CornerWeight::uniform, CornerWeight::area, CornerWeight::angle, CornerWeight::angle_area, CornerWeight::max})
        for (const double crease : {0.0, 60.0, 180.0}) {
            AttributeOptions options;
            options.weight = weight, options.crease_angle_rad = radians(crease);
            for (const std::vector<vec3>& mesh : averaged(parts, values, options))
                for (const vec3& value : mesh) EXPECT_EQ(value, constant);
        }
}

TEST(Average, VerticesAreNumberedAsNormalsAre) {
    auto parts = cut_at_random(make_torus(12, 8), 2, 3);
    parts.push_back(make_cube());
    AttributeOptions options;
    options.crease_angle_rad = radians(30);
    const Values values = faces_of(parts, [](std::size_t m, std::size_t t) { return vec3{float(m), float(t), 0}; });
    const auto out = averaged(parts, values, options);
    const auto normals = compute(parts, options);
    for (std::size_t m = 0; m < parts.size(); ++m) EXPECT_EQ(out[m].size(), normals[m].normals.size());
}

TEST(Average, IsSmoothOverTheBorderOfObjectsAndSharpAtACrease) {
    const Values values = faces_of(make_hinge(0), [](std::size_t m, std::size_t) { return vec3{float(m), 0, 0}; });
    AttributeOptions options;
    options.crease_angle_rad = radians(60);
    for (const auto& [bend, is_smooth] : {std::pair{30.0, true}, {90.0, false}}) {
        const std::vector<Shape> parts = make_hinge(radians(bend));
        const auto out = averaged(parts, values, options);
        const float first = out[0][0].x, second = out[1][0].x;
        EXPECT_EQ(first == second, is_smooth) << bend;
        EXPECT_EQ(second == 1 && first == 0, !is_smooth) << bend;
    }
}

TEST(Average, AMeanIsWeightedAsThePlanSays) {
    // two triangles at the origin: 90 and 45 degrees, areas 1/2 and 1
    const std::vector<Shape> parts = {
        {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-2, 2, 0}}, .indices = {0, 1, 2, 0, 2, 3}}};
    const Values values = {{{0, 0, 0}, {1, 0, 0}}};
    AttributeOptions options;
    for (const auto& [weight, expected] : {std::pair{CornerWeight::uniform, 0.5},
                                           {CornerWeight::angle, 1.0 / 3},
                                           {CornerWeight::area, 2.0 / 3},
                                           {CornerWeight::angle_area, 0.5},
                                           {CornerWeight::max, 0.2}}) {
        options.weight = weight;
        EXPECT_NEAR(averaged(parts, values, options)[0][0].x, expected, 1e-6);
    }
}

TEST(Average, DegenerateFacesHaveNoVote) {
    const std::vector<Shape> parts = {
        {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 2, 0}}, .indices = {0, 1, 2, 0, 2, 3}}};
    const auto out = averaged(parts, {{{1, 2, 3}, {9, 9, 9}}}, {});
    EXPECT_EQ(out[0][0], (vec3{1, 2, 3}));
    EXPECT_EQ(out[0][2], (vec3{1, 2, 3}));
    EXPECT_EQ(out[0][3], vec3{});
}

TEST(Average, TheSameBitsForAnyNumberOfThreads) {
    const auto parts = cut_at_random(make_torus(60, 40), 5, 7);
    const Values values = faces_of(parts, [](std::size_t m, std::size_t t) {
        return vec3{float(t) * 0.1f, 1 / float(t + 1), float(m)};
    });
    EXPECT_EQ(averaged(parts, values, {}, 1), averaged(parts, values, {}, 4));
}

TEST(Average, OtherCountsAreRefused) {
    const std::vector<Shape> parts = {make_cube()};
    const std::size_t count = parts[0].indices.size() / 3;
    EXPECT_EQ(error_of([&] { averaged(parts, {std::vector<vec3>(count - 1)}, {}); }).code(), ErrorCode::bad_file);
    EXPECT_EQ(error_of([&] { averaged(parts, {}, {}); }).code(), ErrorCode::bad_file);
}

}  // namespace
}  // namespace rakelight::test
