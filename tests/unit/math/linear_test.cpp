// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "math/linear.h"

namespace rakelight {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

void expect_near(dvec3 a, dvec3 b, double tolerance = 1e-12) {
    EXPECT_TRUE(std::fabs(a.x - b.x) <= tolerance && std::fabs(a.y - b.y) <= tolerance &&
                std::fabs(a.z - b.z) <= tolerance)
        << a.x << " " << a.y << " " << a.z << " is not " << b.x << " " << b.y << " " << b.z;
}
void expect_near(const dmat4& a, const dmat4& b, double tolerance = 1e-12) {
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t r = 0; r < 4; ++r) EXPECT_NEAR(a[c][r], b[c][r], tolerance) << "column " << c << " row " << r;
}
void expect_rotation(const dmat4& m) {
    const dmat3 r = upper_left(m);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(dot(r[i], r[j]), i == j ? 1 : 0, 1e-12);
    EXPECT_NEAR(determinant(r), 1, 1e-12);
}

TEST(Compose, AppliesScaleThenRotationThenTranslation) {
    const double half = std::sqrt(0.5);  // a quarter turn about z takes x to y
    const dmat4 m = compose({10, 20, 30}, {0, 0, half, half}, {2, 3, 4});
    expect_near(transform_point(m, dvec3{1, 0, 0}), {10, 22, 30});
    expect_near(transform_point(m, dvec3{0, 1, 0}), {7, 20, 30});
    expect_near(transform_point(m, dvec3{0, 0, 1}), {10, 20, 34});
}

TEST(Compose, NormalizesQuaternionsAndTakesBrokenOnesForNoRotation) {
    const dquat quarter{0.5, 0.5, 0.5, 0.5};
    expect_near(compose({0, 0, 0}, {5e200, 5e200, 5e200, 5e200}, {1, 1, 1}), compose({0, 0, 0}, quarter, {1, 1, 1}));
    expect_near(compose({0, 0, 0}, {1e-200, 1e-200, 1e-200, 1e-200}, {1, 1, 1}),
                compose({0, 0, 0}, quarter, {1, 1, 1}));
    expect_near(compose({1, 2, 3}, {0, 0, 0, 0}, {1, 1, 1}), translation(dvec3{1, 2, 3}));
    expect_near(compose({1, 2, 3}, {nan, 0, 0, 1}, {1, 1, 1}), translation(dvec3{1, 2, 3}));
    expect_near(compose({1, 2, 3}, {inf, 0, 0, 1}, {1, 1, 1}), translation(dvec3{1, 2, 3}));
}

TEST(InverseAffine, TimesTheMatrixIsTheIdentity) {
    const dmat4 m = compose({1e3, -2e3, 5}, {0.1, 0.7, -0.3, 0.4}, {2, -3, 0.25});
    dmat4 inverse;
    ASSERT_TRUE(inverse_affine(m, inverse));
    expect_near(m * inverse, dmat4{}, 1e-12);
    expect_near(inverse * m, dmat4{}, 1e-11);
}

TEST(InverseAffine, IsNotFooledByTheUnitOfLength) {
    for (const double s : {1e-120, 1e-9, 1.0, 1e9, 1e120}) {
        dmat4 inverse;
        ASSERT_TRUE(inverse_affine(scaling(dvec3{s, s, s}), inverse)) << s;
        EXPECT_DOUBLE_EQ(inverse[0].x * s, 1) << s;
    }
}

TEST(InverseAffine, RefusesSingularAndBrokenMatricesAndLeavesTheResultAlone) {
    const dmat4 before = translation(dvec3{1, 2, 3});
    for (const dmat4& m : {scaling(dvec3{1, 0, 1}), scaling(dvec3{0, 0, 0}), scaling(dvec3{nan, 1, 1}),
                           scaling(dvec3{inf, 1, 1}), translation(dvec3{nan, 0, 0})}) {
        dmat4 out = before;
        EXPECT_FALSE(inverse_affine(m, out));
        EXPECT_EQ(out, before);
    }
}

TEST(LookAt, PutsTheTargetOnTheNegativeZAxis) {
    const dmat4 m = look_at({1, 2, 3}, {4, 6, 3}, {0, 0, 1});
    expect_rotation(m);
    expect_near(transform_point(m, dvec3{0, 0, -5}), {4, 6, 3});
    EXPECT_GT(transform_direction(m, dvec3{0, 1, 0}).z, 0.999);
}

TEST(LookAt, IsARotationWhateverComesIn) {
    for (const dvec3 target : {dvec3{0, 0, 0}, dvec3{0, 1, 0}, dvec3{0, -1, 0}, dvec3{1e-200, 0, 0}, dvec3{1e200, 1, 0},
                               dvec3{nan, 0, 0}, dvec3{0, 0, inf}})
        for (const dvec3 up :
             {dvec3{0, 1, 0}, dvec3{0, 0, 0}, dvec3{nan, 0, 0}, dvec3{1, 0, 0}, dvec3{0, 1e-300, 1e-300}}) {
            const dmat4 m = look_at({0, 0, 0}, target, up);
            expect_rotation(m);
        }
}

TEST(Perspective, TakesNearAndFarToMinusAndPlusOne) {
    const dmat4 m = perspective(radians(90), 2.0, 0.5, 100);
    const dvec4 near = m * dvec4{0, 0, -0.5, 1}, far = m * dvec4{0, 0, -100, 1}, corner = m * dvec4{20, 10, -10, 1};
    EXPECT_NEAR(near.z / near.w, -1, 1e-12);
    EXPECT_NEAR(far.z / far.w, 1, 1e-12);
    EXPECT_NEAR(corner.x / corner.w, 1, 1e-12);
    EXPECT_NEAR(corner.y / corner.w, 1, 1e-12);
    EXPECT_EQ(corner.w, 10);
}

TEST(Perspective, KnowsAnInfiniteFarPlane) {
    const dmat4 m = perspective(radians(40), 1.5, 0.1, inf);
    const dvec4 near = m * dvec4{0, 0, -0.1, 1}, away = m * dvec4{0, 0, -1e12, 1};
    EXPECT_NEAR(near.z / near.w, -1, 1e-12);
    EXPECT_NEAR(away.z / away.w, 1, 1e-9);
}

TEST(Orthographic, TakesTheBoxToTheUnitCube) {
    const dmat4 m = orthographic(3, 2, -1, 9);
    expect_near((m * dvec4{6, 3, 1, 1}).xyz(), {1, 1, -1});
    expect_near((m * dvec4{-6, -3, -9, 1}).xyz(), {-1, -1, 1});
    EXPECT_EQ((m * dvec4{1, 1, 1, 1}).w, 1);
}

}  // namespace
}  // namespace rakelight
