// SPDX-License-Identifier: Apache-2.0
// The set-up functions: right to an ulp or so, and the same bits everywhere.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

#include <rakelight/math/vector.h>

#include "math/angles.h"
#include "math/functions.h"

namespace rakelight {
namespace {

struct Named {
    const char* name;
    std::function<double(double)> ours, reference;
    double from, to;
};

const Named functions[] = {
    {"sin", math::sin, [](double x) { return std::sin(x); }, -10, 10},
    {"cos", math::cos, [](double x) { return std::cos(x); }, -10, 10},
    {"tan", math::tan, [](double x) { return std::tan(x); }, -1.5, 1.5},
    {"acos", math::acos, [](double x) { return std::acos(x); }, -1, 1},
    {"exp", math::exp, [](double x) { return std::exp(x); }, -50, 50},
    {"exp2", math::exp2, [](double x) { return std::exp2(x); }, -50, 50},
    {"log", math::log, [](double x) { return std::log(x); }, 1e-9, 50},
    {"log2", math::log2, [](double x) { return std::log2(x); }, 1e-9, 50},
    {"pow", [](double x) { return math::pow(x, 2.4); }, [](double x) { return std::pow(x, 2.4); }, 0, 10},
    {"atan2", [](double x) { return math::atan2(x, 0.7); }, [](double x) { return std::atan2(x, 0.7); }, -5, 5},
};

TEST(Functions, AgreeWithTheStandardLibraryToAFewUlps) {
    for (const Named& f : functions)
        for (int i = 0; i <= 4000; ++i) {
            const double x = f.from + (f.to - f.from) * i / 4000;
            const double exact = f.reference(x);
            ASSERT_NEAR(f.ours(x), exact, 3e-16 * std::max(std::fabs(exact), 1e-3) + 1e-300)
                << f.name << "(" << x << ")";
        }
}

const Named angle_functions[] = {
    {"cosine", math::cosine, [](double x) { return std::cos(x); }, -pi, pi},
    {"arc cosine", math::arc_cosine, [](double x) { return std::acos(x); }, -1, 1},
    {"arc cosine", [](double x) { return math::arc_cosine(1 - x); }, [](double x) { return std::acos(1 - x); }, 0,
     1e-9},
    {"arc tangent", [](double x) { return math::arc_tangent(x, 0.7); }, [](double x) { return std::atan2(x, 0.7); }, -5,
     5},
    {"arc tangent", [](double x) { return math::arc_tangent(x, -1e-9); }, [](double x) { return std::atan2(x, -1e-9); },
     -1e-8, 1e-8},
};

TEST(Angles, AgreeWithTheStandardLibraryToTwoUlps) {
    for (const Named& f : angle_functions)
        for (int i = 0; i <= 4000; ++i) {
            const double x = f.from + (f.to - f.from) * i / 4000, exact = f.reference(x);
            ASSERT_NEAR(f.ours(x), exact, 2 * (std::nextafter(std::fabs(exact), 9) - std::fabs(exact)))
                << f.name << "(" << x << ")";
        }
}

TEST(Angles, KnowTheirEdges) {
    constexpr double inf = std::numeric_limits<double>::infinity(), tiny = 5e-324, large = 1.7e308;
    EXPECT_EQ(math::cosine(0), 1);
    EXPECT_EQ(math::cosine(pi), -1);
    EXPECT_EQ(math::arc_cosine(1), 0);
    EXPECT_EQ(math::arc_cosine(-1), pi);
    EXPECT_TRUE(std::isnan(math::arc_cosine(1.0000001)));
    EXPECT_TRUE(std::isnan(math::arc_cosine(-1.0000001)));
    EXPECT_EQ(math::arc_tangent(0, 0), 0);
    EXPECT_EQ(math::arc_tangent(0, -1), pi);
    EXPECT_EQ(math::arc_tangent(-1, 0), -pi / 2);
    EXPECT_EQ(math::arc_tangent(tiny, tiny), pi / 4);
    EXPECT_EQ(math::arc_tangent(large, large), pi / 4);
    EXPECT_EQ(math::arc_tangent(large, tiny), pi / 2);
    EXPECT_EQ(math::arc_tangent(tiny, large), 0);
    EXPECT_TRUE(std::isnan(math::arc_tangent(inf, 1)));
    EXPECT_TRUE(std::isnan(math::arc_tangent(1, std::nan(""))));
}

/// FNV-1a of the bits over each one's range.
template <class Table>
std::uint64_t hash_of(const Table& table) {
    std::uint64_t hash = 1469598103934665603ull;
    for (const Named& f : table)
        for (int i = 0; i <= 4000; ++i)
            hash =
                (hash ^ std::bit_cast<std::uint64_t>(f.ours(f.from + (f.to - f.from) * i / 4000))) * 1099511628211ull;
    return hash;
}

TEST(Angles, HashToTheNumberOfEveryOtherMachine) { EXPECT_EQ(hash_of(angle_functions), 11298791658227709587u); }

TEST(Functions, HashToTheNumberOfEveryOtherMachine) { EXPECT_EQ(hash_of(functions), 13901614809143145094u); }

TEST(Functions, KnowTheirEdges) {
    EXPECT_EQ(math::sin(0.0), 0.0);
    EXPECT_EQ(math::cos(0.0), 1.0);
    EXPECT_EQ(math::acos(1.0), 0.0);
    EXPECT_TRUE(std::isnan(math::acos(1.0000001)));
    EXPECT_DOUBLE_EQ(math::atan2(0.0, -1.0), 3.14159265358979323846);
    EXPECT_EQ(math::exp2(10.0), 1024.0);
    EXPECT_EQ(math::log2(1024.0), 10.0);
    EXPECT_EQ(math::pow(0.0, 0.0), 1.0);
    EXPECT_EQ(math::pow(2.0, -2.0), 0.25);
    EXPECT_EQ(math::exp(-std::numeric_limits<double>::infinity()), 0.0);
    EXPECT_TRUE(std::isnan(math::sin(std::numeric_limits<double>::quiet_NaN())));
}

}  // namespace
}  // namespace rakelight
