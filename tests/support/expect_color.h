// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <gtest/gtest.h>

#include "math/color.h"

namespace rakelight::test {

/// A linear color beside the one that a file has, as displayed (sRGB).
inline void expect_color(const vec4& c, vec3 display, float alpha = 1) {
    const vec3 linear = linear_from_srgb(display);
    EXPECT_NEAR(c.x, linear.x, 1e-6);
    EXPECT_NEAR(c.y, linear.y, 1e-6);
    EXPECT_NEAR(c.z, linear.z, 1e-6);
    EXPECT_NEAR(c.w, alpha, 1e-6);
}

}  // namespace rakelight::test
