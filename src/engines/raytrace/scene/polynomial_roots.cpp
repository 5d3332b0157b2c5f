// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/scene/polynomial_roots.h"

#include <cmath>
#include <utility>

namespace rakelight::raytrace {
namespace {

template <int degree>
double value(const double* c, double x) {
    double v = c[degree];
    for (int i = degree - 1; i >= 0; --i) v = v * x + c[i];
    return v;
}

template <int degree>
double slope(const double* c, double x) {
    double v = degree * c[degree];
    for (int i = degree - 1; i >= 1; --i) v = v * x + i * c[i];
    return v;
}

/// Between low and high the polynomial is monotonic and changes its sign.
template <int degree>
double root_between(const double* c, double low, double high, bool rises) {
    double x = 0.5 * (low + high);
    for (int step = 0; step < 100; ++step) {
        const double v = value<degree>(c, x);
        if (v == 0) return x;
        ((v > 0) == rises ? high : low) = x;
        double next = x - v / slope<degree>(c, x);
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (next == x || !(next > low && next < high)) return x;
        x = next;
    }
    return x;
}

template <int degree>
int roots_of(const double* c, double low, double high, double* out) {
    double bounds[degree + 1];
    int pieces = 0;
    bounds[0] = low;
    if constexpr (degree > 1) {
        double derivative[degree], extrema[degree];
        for (int i = 0; i < degree; ++i) derivative[i] = (i + 1) * c[i + 1];
        const int count = roots_of<degree - 1>(derivative, low, high, extrema);
        for (int i = 0; i < count; ++i) bounds[++pieces] = extrema[i];
    }
    bounds[++pieces] = high;
    int count = 0;
    double before = value<degree>(c, low);
    for (int i = 0; i < pieces; ++i) {
        const double after = value<degree>(c, bounds[i + 1]);
        if ((before < 0 && after >= 0) || (before > 0 && after <= 0))
            out[count++] = root_between<degree>(c, bounds[i], bounds[i + 1], before < 0);
        before = after;
    }
    return count;
}

}  // namespace

Roots quartic_roots(const std::array<double, 5>& c, double low, double high) {
    Roots roots;
    double found[5];
    roots.count = roots_of<4>(c.data(), low, high, found);
    for (int i = 0; i < roots.count; ++i) roots.at[std::size_t(i)] = found[i];
    return roots;
}

Roots quadratic_roots(double a, double b, double c) {
    const double d = b * b - a * c;
    if (!(d >= 0) || a == 0) return {};
    const double q = -(b + std::copysign(std::sqrt(d), b));
    Roots roots{{q / a, q != 0 ? c / q : 0}, 2};
    if (roots.at[0] > roots.at[1]) std::swap(roots.at[0], roots.at[1]);
    return roots;
}

}  // namespace rakelight::raytrace
