// SPDX-License-Identifier: Apache-2.0
#include "shading/lights/alias_table.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "unit/shading/fixed_random.h"

namespace rakelight::shading {
namespace {

using test::chi_square_deviation;
using test::FixedRandom;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double below_one = 1 - 0x1p-53;

/// Weights of many sizes, some of them 0.
std::vector<double> uneven_weights(std::size_t count, FixedRandom& random) {
    std::vector<double> weights(count);
    for (double& w : weights) w = random() < 0.3 ? 0 : std::pow(random(), 4);
    weights[count / 2] = 1;
    return weights;
}

double sum_of(const std::vector<double>& weights) { return std::accumulate(weights.begin(), weights.end(), 0.0); }

TEST(AliasTable, ChoosesAsOftenAsWeightsSay) {
    FixedRandom random(1);
    const std::vector<double> weights = uneven_weights(100, random);
    const AliasTable table(weights);
    ASSERT_EQ(table.size(), 100u);
    constexpr int samples = 1000000;
    std::vector<double> counts(100), expected;
    for (int i = 0; i < samples; ++i) ++counts[table.sample(random()).index];
    for (const double w : weights) expected.push_back(samples * w / sum_of(weights));
    EXPECT_LT(chi_square_deviation(counts, expected), 4);
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_NEAR(table.probability(std::uint32_t(i)), weights[i] / sum_of(weights), 1e-8);
        EXPECT_TRUE(weights[i] > 0 || counts[i] == 0) << i;
    }
}

/// Each element's part of 0..1, measured by even steps: its ends are at most two steps wrong in each of few cells.
TEST(AliasTable, SharesAreExactWhicheverWeightsComeTogether) {
    FixedRandom random(2);
    constexpr int steps = 1 << 14;
    for (int trial = 0; trial < 200; ++trial) {
        const std::vector<double> weights = uneven_weights(1 + std::size_t(trial) % 23, random);
        const AliasTable table(weights);
        std::vector<double> shares(weights.size());
        for (int i = 0; i < steps; ++i) shares[table.sample((i + 0.5) / steps).index] += 1.0 / steps;
        for (std::size_t i = 0; i < weights.size(); ++i)
            EXPECT_NEAR(shares[i], weights[i] / sum_of(weights), (1.0 + double(weights.size())) / steps) << trial;
    }
}

TEST(AliasTable, WhatHasNoWeightIsNeverChosenAtAnyEdge) {
    FixedRandom random(3);
    for (int trial = 0; trial < 300; ++trial) {
        const std::vector<double> weights = uneven_weights(1 + std::size_t(trial) % 37, random);
        const AliasTable table(weights);
        for (int i = 0; i < 64 * int(weights.size()); ++i) {
            const double edge = i / (64.0 * double(weights.size()));
            for (const double u : {edge, std::nextafter(edge, 0.0), std::nextafter(edge, 1.0)}) {
                const AliasTable::Sample s = table.sample(u);
                ASSERT_GT(weights[s.index], 0) << trial;
                ASSERT_EQ(s.probability, table.probability(s.index));
            }
        }
        ASSERT_GT(weights[table.sample(below_one).index], 0);
    }
}

TEST(AliasTable, TheRestIsUniformWithinEachElement) {
    const std::vector<double> weights{1, 5, 0.25, 2, 0, 1.75};
    const AliasTable table(weights);
    FixedRandom random(4);
    constexpr int bins = 16, samples = 400000;
    std::vector<double> counts(weights.size() * bins), expected;
    for (int i = 0; i < samples; ++i) {
        const AliasTable::Sample s = table.sample(random());
        ASSERT_GE(s.rest, 0);
        ASSERT_LT(s.rest, 1);
        ++counts[s.index * bins + std::size_t(s.rest * bins)];
    }
    for (const double w : weights) expected.insert(expected.end(), bins, samples * w / 10 / bins);
    EXPECT_LT(chi_square_deviation(counts, expected), 4);
    EXPECT_LT(table.sample(below_one).rest, 1);
}

TEST(AliasTable, WithoutWeightItIsEmpty) {
    EXPECT_TRUE(AliasTable().empty());
    EXPECT_TRUE(AliasTable(std::vector<double>()).empty());
    EXPECT_TRUE(AliasTable(std::vector<double>{0, 0, 0}).empty());
    EXPECT_TRUE(AliasTable(std::vector<double>{-1, infinity, std::nan("")}).empty());
    EXPECT_FALSE(AliasTable(std::vector<double>{0, 1e-300}).empty());
}

TEST(AliasTable, WhatIsNotFiniteOrNegativeCountsAsNothing) {
    const AliasTable table(std::vector<double>{infinity, 1, std::nan(""), 3, -7, -infinity});
    EXPECT_EQ(table.size(), 6u);
    EXPECT_FLOAT_EQ(table.probability(1), 0.25f);
    EXPECT_FLOAT_EQ(table.probability(3), 0.75f);
    for (const std::uint32_t i : {0u, 2u, 4u, 5u}) EXPECT_EQ(table.probability(i), 0) << i;
}

TEST(AliasTable, OneElementIsAlwaysChosenAndLeavesAllOfTheNumber) {
    const AliasTable table(std::vector<double>{0.001});
    for (const double u : {0.0, 0.3, below_one}) {
        const AliasTable::Sample s = table.sample(u);
        EXPECT_EQ(s.index, 0u);
        EXPECT_EQ(s.probability, 1);
        EXPECT_EQ(s.rest, u);
    }
}

TEST(AliasTable, WeightsNeitherOverflowNorVanish) {
    const AliasTable huge(std::vector<double>{1e308, 1e308, 1e308, 1e308});
    for (std::uint32_t i = 0; i < 4; ++i) EXPECT_FLOAT_EQ(huge.probability(i), 0.25f);
    const AliasTable tiny(std::vector<double>{3e-320, 1e-320});
    EXPECT_NEAR(tiny.probability(0), 0.75f, 1e-3f);
}

}  // namespace
}  // namespace rakelight::shading
