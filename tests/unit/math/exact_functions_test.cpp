// SPDX-License-Identifier: Apache-2.0
// The elementary functions against MPFR, whose results of 200 bits are right to the last one.
#include <gtest/gtest.h>
#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <random>
#include <string>

#include "math/functions.h"

namespace rakelight {
namespace {

constexpr double largest_error_ulps = 0.6;  // functions.h promises 1, and says that this is what is measured
constexpr int count = 12000;

class Number {
public:
    Number() { mpfr_init2(value_, 200); }
    explicit Number(double x) : Number() { mpfr_set_d(value_, x, MPFR_RNDN); }
    ~Number() { mpfr_clear(value_); }
    Number(const Number&) = delete;
    Number& operator=(const Number&) = delete;
    operator mpfr_ptr() { return value_; }
    double nearest() const { return mpfr_get_d(value_, MPFR_RNDN); }

private:
    mpfr_t value_;
};

/// Ulps of `got` from the exact value. An infinity of it counts as 2^1024.
double error_ulps(Number& exact, double got) {
    const double nearest = exact.nearest();
    if (std::bit_cast<std::uint64_t>(nearest) == std::bit_cast<std::uint64_t>(got) && !std::isfinite(got)) return 0;
    if (std::isnan(nearest) || std::isnan(got)) return std::isnan(nearest) && std::isnan(got) ? 0 : 1e99;
    int exponent = 1024;
    if (std::isfinite(nearest)) std::frexp(nearest, &exponent);
    Number difference(std::isfinite(got) ? got : std::copysign(1.0, got));
    if (!std::isfinite(got)) mpfr_mul_2si(difference, difference, 1024, MPFR_RNDN);
    mpfr_sub(difference, exact, difference, MPFR_RNDN);
    mpfr_mul_2si(difference, difference, -std::max(exponent - 53, -1074), MPFR_RNDN);
    return std::fabs(difference.nearest());
}

/// Bits of the generator alone, as distributions are each standard library's own.
class Arguments {
public:
    double between(double from, double to) { return from + (to - from) * (double(random_() >> 11) * 0x1p-53); }
    double signed_power(double from, double to) { return sign() * std::exp2(between(from, to)); }
    double sign() { return random_() & 1 ? 1 : -1; }
    double integer(std::uint64_t end) { return double(random_() % end); }
    double any() {
        for (;;)
            if (const double x = std::bit_cast<double>(random_()); std::isfinite(x)) return x;
    }
    double neighbor(double x) {
        for (std::uint64_t steps = random_() % 4; steps > 0; --steps) x = std::nextafter(x, HUGE_VAL);
        return x;
    }
    /// Near multiple * 2^exponent * pi / 2.
    double near_pi(double multiple, int exponent) {
        Number pi;
        mpfr_const_pi(pi, MPFR_RNDN);
        mpfr_mul_d(pi, pi, sign() * multiple, MPFR_RNDN);
        mpfr_mul_2si(pi, pi, exponent - 1, MPFR_RNDN);
        return neighbor(pi.nearest());
    }

private:
    std::mt19937_64 random_{20261130};
};

struct Worst {
    const char* name;
    double ulps = -1, x = 0, y = 0;

    void add(Number& exact, double got, double at, double at_y = 0) {
        if (const double error = error_ulps(exact, got); error > ulps) ulps = error, x = at, y = at_y;
    }
    ~Worst() {
        std::printf("%-6s %.4f ulp at %a, %a\n", name, ulps, x, y);
        EXPECT_LE(ulps, largest_error_ulps) << name << " of " << x << ", " << y;
    }
};

template <class Ours, class Reference, class... Sets>
void compare(const char* name, Ours ours, Reference reference, Sets... sets) {
    Worst worst{name};
    Number exact;
    const auto at = [&](double x) {
        Number argument(x);
        reference(exact, argument, MPFR_RNDN);
        worst.add(exact, ours(x), x);
    };
    for (int i = 0; i < count; ++i) (at(sets()), ...);
}

template <class Ours, class Reference, class... Sets>
void compare_pairs(const char* name, Ours ours, Reference reference, Sets... sets) {
    Worst worst{name};
    Number exact;
    const auto at = [&](std::pair<double, double> arguments) {
        const auto [x, y] = arguments;
        Number a(x), b(y);
        reference(exact, a, b, MPFR_RNDN);
        worst.add(exact, ours(x, y), x, y);
    };
    for (int i = 0; i < count; ++i) (at(sets()), ...);
}

template <class Ours, class Reference>
void compare_angles(const char* name, Ours ours, Reference reference) {
    Arguments a;
    compare(
        name, ours, reference, [&] { return a.any(); }, [&] { return a.between(-10, 10); },
        [&] { return a.between(-0.8, 0.8); }, [&] { return a.signed_power(-1074, 0); },
        [&] { return a.near_pi(a.integer(2000000), 0); },
        [&] { return a.near_pi(a.integer(1ull << 53), int(a.integer(970))); },
        // The double nearest to a multiple of pi / 2, and its neighbors.
        [&] { return a.sign() * a.neighbor(0x1.6ac5b262ca1fdp+849); });
}

TEST(ExactFunctions, SinesOfAllAnglesAreExactToAnUlp) {
    compare_angles("sin", math::sin, mpfr_sin);
    compare_angles("cos", math::cos, mpfr_cos);
}

TEST(ExactFunctions, TangentsOfAllAnglesAreExactToAnUlp) { compare_angles("tan", math::tan, mpfr_tan); }

TEST(ExactFunctions, ArcCosinesAreExactToAnUlp) {
    Arguments a;
    compare(
        "acos", math::acos, mpfr_acos, [&] { return a.between(-1, 1); },
        [&] { return a.sign() * (1 - std::exp2(a.between(-53, -1))); }, [&] { return a.signed_power(-1074, 0); },
        [&] { return a.sign() * a.neighbor(std::sqrt(0.5)); });
}

TEST(ExactFunctions, ArcTangentsAreExactToAnUlp) {
    Arguments a;
    using Pair = std::pair<double, double>;
    compare_pairs(
        "atan2", math::atan2, mpfr_atan2, [&] { return Pair(a.between(-1, 1), a.between(-1, 1)); },
        [&] { return Pair(a.any(), a.any()); },
        [&] {
            const double size = std::exp2(a.between(-1060, 1000));
            return Pair(a.signed_power(-62, 20) * size, a.sign() * size);
        },
        [&] { return Pair(a.sign() * a.integer(2000) * 0x1p-1074, a.sign() * a.integer(2000) * 0x1p-1074); },
        [&] { return Pair(a.any(), a.sign() * a.integer(2)); });
}

TEST(ExactFunctions, PowersOfEAndTwoAreExactToAnUlp) {
    Arguments a;
    compare(
        "exp", math::exp, mpfr_exp, [&] { return a.between(-708, 709.7); }, [&] { return a.between(-746, -707); },
        [&] { return a.between(709, 710); }, [&] { return a.between(-1, 1); }, [&] { return a.any(); },
        [&] { return a.signed_power(-70, 0); }, [&] { return a.sign() * a.neighbor(0x1.62e42fefa39efp+9); });
    compare(
        "exp2", math::exp2, mpfr_exp2, [&] { return a.between(-1022, 1024); }, [&] { return a.between(-1076, -1020); },
        [&] { return a.between(-1, 1); }, [&] { return a.any(); }, [&] { return a.signed_power(-70, 0); },
        [&] { return a.neighbor(a.integer(2100) - 1076); });
}

template <class Ours, class Reference>
void compare_logarithms(const char* name, Ours ours, Reference reference) {
    Arguments a;
    compare(
        name, ours, reference, [&] { return std::fabs(a.any()); }, [&] { return a.between(0.5, 2); },
        [&] { return 1 + a.signed_power(-53, -3); }, [&] { return std::exp2(a.between(-1074, -1020)); },
        [&] { return a.integer(1000) * 0x1p-1074; }, [&] { return a.neighbor(a.integer(64) / 32); });
}

TEST(ExactFunctions, LogarithmsAreExactToAnUlp) {
    compare_logarithms("log", math::log, mpfr_log);
    compare_logarithms("log2", math::log2, mpfr_log2);
}

TEST(ExactFunctions, PowersAreExactToAnUlp) {
    Arguments a;
    using Pair = std::pair<double, double>;
    const auto to = [&](double x, double from, double end) { return Pair(x, a.between(from, end) / std::log(x)); };
    compare_pairs(
        "pow", math::pow, mpfr_pow, [&] { return Pair(a.between(0, 10), a.between(-5, 5)); },
        [&] { return Pair(std::fabs(a.any()), a.between(-2, 2)); },
        [&] { return to(std::exp2(a.between(-30, 30)), -745, 710); },
        [&] { return to(1 + a.between(-0.04, 0.04), -745, 710); },
        [&] { return to(1 + a.signed_power(-53, -3), -745, 710); },
        [&] { return to(std::exp2(a.between(-1074, 1024)), -746, -705); },
        [&] { return to(std::exp2(a.between(-1074, 1024)), 709, 710); },
        [&] { return Pair(std::exp2(a.between(-1074, -1020)), a.between(-1, 1.05)); },
        [&] { return Pair(a.integer(200) - 100, a.integer(200) - 100); },
        [&] { return Pair(std::exp2(a.between(-1000, 1000)), a.signed_power(-70, 0)); },
        [&] { return Pair(a.any(), a.any()); });
}

}  // namespace
}  // namespace rakelight
