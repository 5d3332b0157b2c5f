// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include "tools/stages/canvas.h"

namespace rakelight::stages {
namespace {

// Where a line enters is rounded: some ends lie at -1e-16. A pixel left of the first one is the last of the row above,
// or, in the first row, other memory: the address sanitizer sees it.
TEST(LineCounts, ALineThatEntersFromOutsideStaysInside) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-300, 360);
    for (int i = 0; i < 20000; ++i) {
        LineCounts counts(64, 1);
        counts.line({place(random), place(random)}, {place(random), place(random)});
        const double mean = counts.mean();
        ASSERT_TRUE(mean == 0 || mean >= 1) << i;
    }
}

}  // namespace
}  // namespace rakelight::stages
