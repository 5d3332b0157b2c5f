// SPDX-License-Identifier: Apache-2.0
// Random numbers that are the same everywhere, and how far counts are from what was expected.
#pragma once
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace rakelight::test {

class FixedRandom {
public:
    explicit FixedRandom(std::uint64_t seed) : bits_(seed) {}
    /// [0, 1)
    double operator()() { return double(bits_() >> 11) * 0x1p-53; }

private:
    std::mt19937_64 bits_;
};

/// Pearson's chi-square in standard deviations from its mean. Cells that expect fewer than 5 are one cell. Of right counts it
/// is 0 +- 1, of counts of n samples with relative errors e about n e^2 / sqrt(2 cells).
inline double chi_square_deviation(const std::vector<double>& counts, const std::vector<double>& expected) {
    double sum = 0, few_counts = 0, few_expected = 0;
    int freedom = -1;
    const auto add = [&](double count, double wanted) {
        sum += (count - wanted) * (count - wanted) / wanted;
        ++freedom;
    };
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (expected[i] < 5)
            few_counts += counts[i], few_expected += expected[i];
        else
            add(counts[i], expected[i]);
    }
    if (few_expected >= 5) add(few_counts, few_expected);
    return (sum - freedom) / std::sqrt(2.0 * freedom);
}

}  // namespace rakelight::test
