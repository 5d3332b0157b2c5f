// SPDX-License-Identifier: Apache-2.0
// The elementary functions at zeros, infinities and NaN, where results are exact, and their bits on every machine.
// Their errors are in exact_functions_test.cpp.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

#include <rakelight/math/vector.h>

#include "math/functions.h"

namespace rakelight {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max(), least = 0x1p-1074;

/// The same bits, so that zeros have the same sign; or NaN both.
::testing::AssertionResult is_same(double a, double b) {
    if (std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b)))
        return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << a << " is not " << b;
}

TEST(Functions, OfAnglesKnowTheirEdges) {
    for (const auto f : {math::sin, math::tan}) {
        for (const double x : {0.0, -0.0, least, -least, 0x1p-1022, -0x1p-600}) EXPECT_TRUE(is_same(f(x), x));
        for (const double x : {inf, -inf, nan}) EXPECT_TRUE(std::isnan(f(x)));
    }
    for (const double x : {0.0, -0.0, least, -least}) EXPECT_TRUE(is_same(math::cos(x), 1));
    for (const double x : {inf, -inf, nan}) EXPECT_TRUE(std::isnan(math::cos(x)));
    EXPECT_EQ(math::cos(pi), -1);
    EXPECT_EQ(math::sin(pi / 2), 1);
    EXPECT_EQ(math::sin(pi), 0x1.1a62633145c07p-53);
    EXPECT_EQ(math::tan(pi / 2), 0x1.d02967c31cdb5p+53);
}

TEST(Functions, ArcCosineKnowsItsEdges) {
    EXPECT_TRUE(is_same(math::acos(1), 0));
    EXPECT_EQ(math::acos(-1), pi);
    for (const double x : {0.0, -0.0, least, -least}) EXPECT_EQ(math::acos(x), pi / 2);
    for (const double x : {1 + 0x1p-52, -1 - 0x1p-52, inf, -inf, nan}) EXPECT_TRUE(std::isnan(math::acos(x)));
}

// C99, F.9.1.4
TEST(Functions, ArcTangentKnowsItsEdges) {
    for (const double sign : {1.0, -1.0}) {
        const double zero = 0.0 * sign, infinity = inf * sign;
        for (const double x : {0.0, least, 1.0, inf}) {
            EXPECT_TRUE(is_same(math::atan2(zero, x), zero));
            EXPECT_TRUE(is_same(math::atan2(zero, -x), pi * sign));
        }
        for (const double y : {least, 1.0, largest}) {
            EXPECT_TRUE(is_same(math::atan2(y * sign, 0.0), pi / 2 * sign));
            EXPECT_TRUE(is_same(math::atan2(y * sign, -0.0), pi / 2 * sign));
            EXPECT_TRUE(is_same(math::atan2(y * sign, inf), zero));
            EXPECT_TRUE(is_same(math::atan2(y * sign, -inf), pi * sign));
            EXPECT_TRUE(is_same(math::atan2(infinity, y), pi / 2 * sign));
            EXPECT_TRUE(is_same(math::atan2(infinity, -y), pi / 2 * sign));
            EXPECT_TRUE(is_same(math::atan2(y * sign, y), pi / 4 * sign));
        }
        EXPECT_TRUE(is_same(math::atan2(infinity, inf), pi / 4 * sign));
        EXPECT_TRUE(is_same(math::atan2(infinity, -inf), 3 * pi / 4 * sign));
        EXPECT_TRUE(is_same(math::atan2(largest * sign, least), pi / 2 * sign));
        EXPECT_TRUE(is_same(math::atan2(least * sign, largest), zero));
    }
    for (const double x : {0.0, 1.0, inf, nan}) {
        EXPECT_TRUE(std::isnan(math::atan2(nan, x)));
        EXPECT_TRUE(std::isnan(math::atan2(x, nan)));
    }
}

TEST(Functions, ExponentialsKnowTheirEdges) {
    for (const auto f : {math::exp, math::exp2}) {
        for (const double x : {0.0, -0.0, least, -least}) EXPECT_TRUE(is_same(f(x), 1));
        for (const double x : {inf, largest, 1024.0}) EXPECT_TRUE(is_same(f(x), inf));
        for (const double x : {-inf, -largest, -1076.0}) EXPECT_TRUE(is_same(f(x), 0));
        EXPECT_TRUE(std::isnan(f(nan)));
    }
    for (int n = -1074; n < 1024; ++n) EXPECT_EQ(math::exp2(n), std::ldexp(1.0, n));
}

TEST(Functions, LogarithmsKnowTheirEdges) {
    for (const auto f : {math::log, math::log2}) {
        for (const double x : {0.0, -0.0}) EXPECT_TRUE(is_same(f(x), -inf));
        EXPECT_TRUE(is_same(f(1), 0));
        EXPECT_TRUE(is_same(f(inf), inf));
        for (const double x : {-least, -1.0, -inf, nan}) EXPECT_TRUE(std::isnan(f(x)));
    }
    for (int n = -1074; n < 1024; ++n) EXPECT_EQ(math::log2(std::ldexp(1.0, n)), n);
}

// C99, F.9.4.4
TEST(Functions, PowersOfZeroKnowTheirEdges) {
    for (const double y : {1.0, 3.0, 0x1p53 - 1}) {  // odd
        EXPECT_TRUE(is_same(math::pow(0.0, y), 0));
        EXPECT_TRUE(is_same(math::pow(-0.0, y), -0.0));
        EXPECT_TRUE(is_same(math::pow(0.0, -y), inf));
        EXPECT_TRUE(is_same(math::pow(-0.0, -y), -inf));
        EXPECT_TRUE(is_same(math::pow(-inf, -y), -0.0));
        EXPECT_TRUE(is_same(math::pow(-inf, y), -inf));
    }
    for (const double y : {least, 0.5, 2.0, 2.5, 0x1p53, largest, inf}) {
        for (const double zero : {0.0, -0.0}) {
            EXPECT_TRUE(is_same(math::pow(zero, y), 0));
            EXPECT_TRUE(is_same(math::pow(zero, -y), inf));
        }
        for (const double infinity : {inf, -inf}) {
            EXPECT_TRUE(is_same(math::pow(infinity, -y), 0));
            EXPECT_TRUE(is_same(math::pow(infinity, y), inf));
        }
    }
}

TEST(Functions, OtherPowersKnowTheirEdges) {
    for (const double x : {0.0, -0.0, 1.0, -1.0, least, largest, inf, -inf, nan}) {
        EXPECT_TRUE(is_same(math::pow(x, 0.0), 1));
        EXPECT_TRUE(is_same(math::pow(x, -0.0), 1));
        EXPECT_TRUE(is_same(math::pow(1, x), 1));
    }
    for (const double x : {0.0, -1.0, 2.0, inf}) EXPECT_TRUE(std::isnan(math::pow(x, nan)));
    for (const double y : {1.0, -2.0, inf}) EXPECT_TRUE(std::isnan(math::pow(nan, y)));
    for (const double y : {inf, -inf, 0x1p60}) EXPECT_TRUE(is_same(math::pow(-1, y), 1));
    for (const double x : {1 - 0x1p-53, 0.5, -0.5, least}) {
        EXPECT_TRUE(is_same(math::pow(x, inf), 0));
        EXPECT_TRUE(is_same(math::pow(x, -inf), inf));
        EXPECT_TRUE(is_same(math::pow(1 / x, inf), inf));
        EXPECT_TRUE(is_same(math::pow(1 / x, -inf), 0));
    }
    for (const double x : {-1.0, -least, -largest}) EXPECT_TRUE(std::isnan(math::pow(x, 0.5)));
    EXPECT_TRUE(is_same(math::pow(-2, 3), -8));
    EXPECT_TRUE(is_same(math::pow(-2, 4), 16));
    EXPECT_TRUE(is_same(math::pow(-2, -2), 0.25));
    EXPECT_TRUE(is_same(math::pow(-2, 1025), -inf));
    EXPECT_TRUE(is_same(math::pow(-2, -1077), -0.0));
    EXPECT_TRUE(is_same(math::pow(-1, 0x1p53 - 1), -1));
    EXPECT_TRUE(is_same(math::pow(largest, largest), inf));
    EXPECT_TRUE(is_same(math::pow(largest, -largest), 0));
}

struct Named {
    std::function<double(double)> function;
    double from, to;
};

const Named functions[] = {
    {math::sin, -10, 10},
    {math::cos, -10, 10},
    {math::sin, 1e22, 1e308},
    {math::tan, -1.5, 1.5},
    {math::acos, -1, 1},
    {math::exp, -750, 710},
    {math::exp2, -50, 50},
    {math::log, 1e-9, 50},
    {math::log2, 1e-9, 50},
    {[](double x) { return math::pow(x, 2.4); }, 0, 10},
    {[](double x) { return math::pow(0.3, x); }, -620, 620},
    {[](double x) { return math::atan2(x, 0.7); }, -5, 5},
    {[](double x) { return math::atan2(x, -1e-9); }, -1e-8, 1e-8},
};

TEST(Functions, HashToTheNumberOfEveryOtherMachine) {
    std::uint64_t hash = 1469598103934665603ull;  // FNV-1a
    for (const Named& f : functions)
        for (int i = 0; i <= 4000; ++i)
            hash = (hash ^ std::bit_cast<std::uint64_t>(f.function(f.from + (f.to - f.from) * i / 4000))) *
                   1099511628211ull;
    EXPECT_EQ(hash, 16864358093077524510u);
}

}  // namespace
}  // namespace rakelight
