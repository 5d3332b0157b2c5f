// SPDX-License-Identifier: Apache-2.0
// Every operation of math/wide.h gives the same bits in every flavour that this processor has, and the right ones.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "math/flush_denormals.h"
#include "math/isa.h"
#include "wide_kernel.h"

namespace rakelight {

namespace wide_test {
static Kernel kernel_for(Isa isa) { return RL_BY_ISA(isa, kernel); }
}  // namespace wide_test

namespace {

using wide_test::Inputs;
using wide_test::Kernel;
using wide_test::Operation;

struct Flavour {
    Isa isa;
    Kernel kernel;
};

std::vector<Flavour> flavours() {
    std::vector<Flavour> all;
    for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512})
        if (is_available(isa)) all.push_back({isa, wide_test::kernel_for(isa)});
    return all;
}

const Operation& operation(const Kernel& kernel, const std::string& name) {
    for (int i = 0; i < kernel.operation_count; ++i)
        if (kernel.operations[i].name == name) return kernel.operations[i];
    throw std::runtime_error("no operation " + name);
}

const std::vector<float>& special_values() {
    using L = std::numeric_limits<float>;
    static const std::vector<float> values = {0.0f,
                                              -0.0f,
                                              0.3f,
                                              -0.3f,
                                              0.5f,
                                              -0.5f,
                                              1.0f,
                                              -1.0f,
                                              1.5f,
                                              -1.5f,
                                              2.0f,
                                              48.0f,
                                              126.0f,
                                              127.0f,
                                              127.99999f,
                                              128.0f,
                                              -126.0f,
                                              -126.00001f,
                                              -127.0f,
                                              -149.0f,
                                              -150.0f,
                                              8388607.5f,
                                              -8388607.5f,
                                              8388608.0f,
                                              -8388609.0f,
                                              2147483520.0f,
                                              2147483648.0f,
                                              -2147483648.0f,
                                              -2147483904.0f,
                                              1e10f,
                                              -1e10f,
                                              1e-10f,
                                              L::min(),
                                              -L::min(),
                                              L::min() / 2,
                                              -L::denorm_min(),
                                              L::denorm_min(),
                                              L::max(),
                                              -L::max(),
                                              L::infinity(),
                                              -L::infinity(),
                                              L::quiet_NaN(),
                                              0.99999994f,
                                              1.0000001f,
                                              1e19f,
                                              2e19f,
                                              1e-19f,
                                              1e-20f};
    return values;
}

/// Triples: every pair of special values, then numbers of usual size, then random bits. Filled up to a multiple of 32.
struct Triples {
    std::vector<float> a, b, c;
    Triples() {
        const auto& special = special_values();
        for (std::size_t i = 0; i < special.size(); ++i)
            for (std::size_t j = 0; j < special.size(); ++j)
                push({special[i], special[j], special[(i + 3 * j) % special.size()]});
        std::mt19937 random(2024);  // its numbers are the same everywhere, unlike those of std::*_distribution
        const auto usual = [&](float width) { return (float(random() >> 8) / 16777216.0f - 0.5f) * width; };
        // braces: the order of a call's arguments is the compiler's choice
        for (int i = 0; i < 60000; ++i) push(Triple{usual(4), usual(i % 2 ? 4 : 200), usual(4)});
        const auto any = [&] { return std::bit_cast<float>(std::uint32_t(random())); };
        for (int i = 0; i < 60000; ++i) push(Triple{any(), any(), any()});
        while (a.size() % 32 != 0) push({1, 1, 1});
    }
    struct Triple {
        float x, y, z;
    };
    void push(Triple t) { a.push_back(t.x), b.push_back(t.y), c.push_back(t.z); }
    Inputs inputs() const { return {a.data(), b.data(), c.data(), int(a.size())}; }
};

const Triples& triples() {
    static const Triples made_once;
    return made_once;
}

std::uint32_t bits(float x, bool is_real) {
    return is_real && std::isnan(x) ? 0x7fc00000u : std::bit_cast<std::uint32_t>(x);
}

std::vector<float> results(const Operation& op, const Inputs& in) {
    std::vector<float> out(std::size_t(in.count), -77.0f);
    op.run(in, out.data());
    return out;
}

void expect_all_flavours_equal() {
    const Inputs in = triples().inputs();
    const Kernel& reference = wide_test::scalar::kernel;
    for (int o = 0; o < reference.operation_count; ++o) {
        const Operation& op = reference.operations[o];
        const std::vector<float> expected = results(op, in);
        std::vector<Flavour> all = flavours();
#if defined(__x86_64__)
        if (is_available(Isa::avx512)) all.push_back({Isa::avx512, wide_test::avx512x2::kernel});
#endif
        for (const Flavour& flavour : all) {
            const std::vector<float> got = results(flavour.kernel.operations[o], in);
            for (std::size_t k = 0; k < got.size(); ++k)
                if (bits(got[k], op.is_real) != bits(expected[k], op.is_real)) {
                    ADD_FAILURE() << op.name << " in " << name(flavour.isa) << " by " << flavour.kernel.lanes << " of "
                                  << in.a[k] << ", " << in.b[k] << ", " << in.c[k] << ": " << got[k] << ", scalar "
                                  << expected[k];
                    break;
                }
        }
    }
}

TEST(Wide, EveryOperationGivesTheBitsOfTheScalarFlavour) { expect_all_flavours_equal(); }

TEST(Wide, EveryOperationGivesTheBitsOfTheScalarFlavourWithDenormalsFlushed) {
    const FlushDenormals guard;
    expect_all_flavours_equal();
}

TEST(Wide, LanesAreThoseOfTheInstructionSet) {
    for (const Flavour& f : flavours()) {
        const int expected = f.isa == Isa::scalar ? 1 : f.isa == Isa::sse2 ? 4 : f.isa == Isa::avx2 ? 8 : 16;
        EXPECT_EQ(f.kernel.lanes, expected) << name(f.isa);
    }
}

TEST(Wide, ResultsHashToTheNumberOfEveryOtherMachine) {
    // FNV-1a over all results of the scalar flavour. A changed number means changed pictures: say so in the changelog.
    std::uint64_t hash = 1469598103934665603ull;
    for (int o = 0; o < wide_test::scalar::kernel.operation_count; ++o) {
        const Operation& op = wide_test::scalar::kernel.operations[o];
        for (const float x : results(op, triples().inputs())) hash = (hash ^ bits(x, op.is_real)) * 1099511628211ull;
    }
    EXPECT_EQ(hash, 10257325371644981179u);
}

void expect_same_as(const std::string& name, const std::function<float(float)>& expected) {
    const std::vector<float> got = results(operation(wide_test::scalar::kernel, name), triples().inputs());
    for (std::size_t k = 0; k < got.size(); ++k)
        ASSERT_EQ(bits(got[k], true), bits(expected(triples().a[k]), true))
            << name << " of " << triples().a[k] << ": " << got[k];
}

TEST(Wide, RoundingKeepsTheSignOfZeroAsTheStandardSays) {
    expect_same_as("floored", [](float x) { return std::floor(x); });
    expect_same_as("ceiled", [](float x) { return std::ceil(x); });
    expect_same_as("truncated", [](float x) { return std::trunc(x); });
}

TEST(Wide, SquareRootAndReciprocalRoundCorrectly) {
    expect_same_as("square_root", [](float x) { return std::sqrt(x); });
    expect_same_as("reciprocal_of", [](float x) { return 1.0f / x; });
}

TEST(Wide, ToIntegerGivesTheSmallestOneOutOfRange) {
    const std::vector<float> got =
        results(operation(wide_test::scalar::kernel, "truncated_to_integer"), triples().inputs());
    for (std::size_t k = 0; k < got.size(); ++k) {
        const float x = triples().a[k];
        const std::int32_t expected =
            x > -2147483904.0f && x < 2147483648.0f ? std::int32_t(x) : std::numeric_limits<std::int32_t>::min();
        ASSERT_EQ(std::bit_cast<std::int32_t>(got[k]), expected) << x;
    }
}

TEST(Wide, MinimumAndMaximumTakeTheSecondWhereTheComparisonFails) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float a[16] = {nan, 1, 0.0f, -0.0f, 1}, b[16] = {1, nan, -0.0f, 0.0f, 2}, c[16] = {};
    for (const Flavour& f : flavours())
        for (const char* op : {"smaller", "larger"}) {
            const std::vector<float> got = results(operation(f.kernel, op), {a, b, c, 16});
            for (std::size_t k = 0; k < 4; ++k)
                EXPECT_EQ(bits(got[k], true), bits(b[k], true)) << op << " " << k << " " << name(f.isa);
            EXPECT_EQ(got[4], op == std::string("smaller") ? 1.0f : 2.0f);
        }
}

TEST(Wide, DenormalArgumentsAndResultsOfPowersAreZeroWhetherFlushedOrNot) {
    for (const char* op : {"power_of_two", "binary_logarithm", "power", "power_of_magnitude"}) {
        const std::vector<float> kept = results(operation(wide_test::scalar::kernel, op), triples().inputs());
        std::vector<float> flushed;
        {
            const FlushDenormals guard;
            flushed = results(operation(wide_test::scalar::kernel, op), triples().inputs());
        }
        for (std::size_t k = 0; k < kept.size(); ++k) {
            // y log2(x) itself may be denormal: then 2^it is 1 either way
            ASSERT_EQ(bits(kept[k], true), bits(flushed[k], true))
                << op << " of " << triples().a[k] << ", " << triples().b[k];
            ASSERT_NE(std::fpclassify(kept[k]), FP_SUBNORMAL)
                << op << " of " << triples().a[k] << ", " << triples().b[k];
        }
    }
}

TEST(Wide, PowersAndLogarithmsKeepTheirStatedAccuracy) {
    std::vector<float> x, y, c;
    for (int i = 0; i < 200000; ++i) {
        x.push_back(std::exp2(-30.0f + float(i) * 3.1e-4f));  // 2^-30 .. 2^32
        y.push_back(-126.0f + float(i) * 1.27e-3f);           // -126 .. 128
    }
    c = y;
    const Kernel& k = wide_test::scalar::kernel;
    const auto log2_x = results(operation(k, "binary_logarithm"), {x.data(), y.data(), c.data(), int(x.size())});
    const auto exp2_y = results(operation(k, "power_of_two"), {y.data(), x.data(), c.data(), int(x.size())});
    double worst_log2 = 0, worst_exp2 = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double exact = std::log2(double(x[i]));
        if (exact != 0) worst_log2 = std::max(worst_log2, std::fabs(double(log2_x[i]) / exact - 1));
        worst_exp2 = std::max(worst_exp2, std::fabs(double(exp2_y[i]) / std::exp2(double(y[i])) - 1));
    }
    EXPECT_LT(worst_log2, 3e-7);
    EXPECT_LT(worst_exp2, 2e-7);
    const auto coarse = results(operation(k, "binary_logarithm_coarse"), {x.data(), y.data(), c.data(), int(x.size())});
    for (std::size_t i = 0; i < x.size(); ++i) ASSERT_NEAR(coarse[i], std::log2(double(x[i])), 4e-4) << x[i];

    std::vector<float> base, exponent;
    for (int i = 1; i <= 1600; ++i)
        for (const float e : {1.0f, 2.0f, 5.5f, 48.0f, 1000.0f})
            base.push_back(float(i) / 1600.0f), exponent.push_back(e);
    const auto power = results(operation(k, "power"), {base.data(), exponent.data(), base.data(), int(base.size())});
    for (std::size_t i = 0; i < base.size(); ++i) {
        const double exact = std::pow(double(base[i]), double(exponent[i]));
        if (exact >= std::exp2(-20.0)) {
            ASSERT_NEAR(power[i] / exact, 1.0, 6e-6) << base[i] << "^" << exponent[i];
        }
    }
}

TEST(Wide, PowersKnowTheirEdges) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const float x[16] = {0, -1, nan, 1, 1, 1e-40f, 0, 2, 0.5f, inf, 2, 4},
                y[16] = {0, 2, 1, 1e30f, -5, 1, 1, nan, 200, 1, 10, 0.5f};
    const float expected[16] = {0, 0, 0, 1, 1, 0, 0, 0, 0, inf, 1024, 2};
    for (const Flavour& f : flavours()) {
        const auto got = results(operation(f.kernel, "power"), {x, y, y, 16});
        for (std::size_t k = 0; k < 12; ++k)
            EXPECT_EQ(got[k], expected[k]) << x[k] << "^" << y[k] << " in " << name(f.isa);
    }
}

TEST(Wide, DirectionsThatFloatCannotHoldNormalizeToTheZAxis) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const float a[16] = {0, 1e-25f, nan, inf, 1e30f, 3}, b[16] = {}, c[16] = {0, 0, 1, 1, 0, 4};
    for (const Flavour& f : flavours()) {
        const auto x = results(operation(f.kernel, "safely_normalized_x"), {a, b, c, 16});
        const auto z = results(operation(f.kernel, "safely_normalized_z"), {a, b, c, 16});
        for (std::size_t k = 0; k < 5; ++k) EXPECT_TRUE(x[k] == 0 && z[k] == 1) << a[k] << " in " << name(f.isa);
        EXPECT_FLOAT_EQ(x[5], 0.6f);
        EXPECT_FLOAT_EQ(z[5], 0.8f);
    }
}

TEST(Wide, StoresAndLoadsLeaveTheMemoryOfDeadLanesAlone) {
    const float x[16] = {1, -1, 2, 0, -3, 3, 4, -5, 0, 0, 5, 6, -7, 7, -8, 8};
    std::int32_t i[16];
    for (int k = 0; k < 16; ++k) i[k] = std::int32_t(x[k]);
    for (const Flavour& f : flavours()) {
        std::vector<float> out(16, -9.0f);
        std::vector<std::int32_t> integers(16, -9);
        f.kernel.store_positive(x, out.data(), 16);
        f.kernel.store_positive_integers(i, integers.data(), 16);
        for (std::size_t k = 0; k < 16; ++k) {
            EXPECT_EQ(out[k], x[k] > 0 ? x[k] + 1 : -9.0f) << name(f.isa);
            EXPECT_EQ(integers[k], x[k] > 0 ? i[k] + 1 : -9) << name(f.isa);
        }
    }
}

TEST(Wide, VotesCountEveryLane) {
    for (const Flavour& f : flavours()) {
        const std::uint32_t all = (std::uint32_t(1) << f.kernel.lanes) - 1;
        for (std::uint32_t pattern : {0u, all, 1u, all >> 1, all & ~1u, all & 0x5555u, 1u << (f.kernel.lanes - 1)}) {
            float x[16];
            for (int k = 0; k < 16; ++k) x[k] = (pattern >> k & 1) != 0 ? 1.0f : -1.0f;
            const std::uint32_t expected =
                (pattern != 0 ? 1u : 0u) | (pattern == all ? 2u : 0u) | (pattern == 0 ? 4u : 0u) | pattern << 8;
            EXPECT_EQ(f.kernel.vote(x), expected) << name(f.isa) << " pattern " << pattern;
        }
    }
}

TEST(Wide, LanesComeApartInOrder) {
    float x[16];
    for (int k = 0; k < 16; ++k) x[k] = k % 3 == 0 ? -float(k) : float(k) + 0.25f;
    for (const Flavour& f : flavours()) {
        std::int32_t indices[16], integers[16];
        float reals[16];
        bool truths[16];
        f.kernel.take_apart(x, indices, reals, integers, truths);
        for (int k = 0; k < f.kernel.lanes; ++k) {
            EXPECT_EQ(indices[k], k);
            EXPECT_EQ(reals[k], x[k]);
            EXPECT_EQ(integers[k], std::bit_cast<std::int32_t>(x[k]));
            EXPECT_EQ(truths[k], x[k] > 0);
        }
    }
}

}  // namespace
}  // namespace rakelight
