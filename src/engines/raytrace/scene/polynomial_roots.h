// SPDX-License-Identifier: Apache-2.0
// Real roots of polynomials of degree up to 4, without loss where roots nearly meet: between two extrema a polynomial has at most
// one, which is closed in on by Newton's method and bisection. Source: Yuksel 2022, "High-Performance Polynomial Root Finding for
// Graphics", sections 3 and 4.
#pragma once
#include <array>

namespace rakelight::raytrace {

struct Roots {
    std::array<double, 4> at{};
    int count = 0;
};

/// Of c[0] + c[1] x + ... + c[4] x^4 in low..high, in rising order. A root that is an extremum too, where the sign does not change,
/// may be missing. Numbers are finite.
Roots quartic_roots(const std::array<double, 5>& c, double low, double high);

/// Of a x^2 + 2 b x + c, in rising order; a > 0 or a < 0. Without cancellation.
Roots quadratic_roots(double a, double b, double c);

}  // namespace rakelight::raytrace
