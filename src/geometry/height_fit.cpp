// SPDX-License-Identifier: Apache-2.0
#include "geometry/height_fit.h"

#include <algorithm>
#include <cmath>

#include "math/linear.h"

namespace rakelight::geometry {
namespace {

/// A symmetric matrix, of which the lower half is used, and a vector.
template <int K>
struct Equations {
    double a[K][K] = {}, r[K] = {};
    double heights = 0;  ///< sum of weight times the square of the height
    double weight = 0;
};

/// Cholesky's factor, in place. @return whether the matrix is positive definite
template <int K>
bool factor(double (&a)[K][K]) {
    for (int j = 0; j < K; ++j) {
        double d = a[j][j];
        for (int k = 0; k < j; ++k) d -= a[j][k] * a[j][k];
        if (!(d > 1e-14)) return false;
        a[j][j] = std::sqrt(d);
        for (int i = j + 1; i < K; ++i) {
            double s = a[i][j];
            for (int k = 0; k < j; ++k) s -= a[i][k] * a[j][k];
            a[i][j] = s / a[j][j];
        }
    }
    return true;
}

/// The reciprocal of the trace of the inverse of a matrix, by its factor.
template <int K>
double reciprocal_trace(const double (&l)[K][K]) {
    double trace = 0, x[K];
    for (int c = 0; c < K; ++c) {  // a column of the factor's inverse
        for (int i = c; i < K; ++i) {
            double s = i == c ? 1.0 : 0.0;
            for (int k = c; k < i; ++k) s -= l[i][k] * x[k];
            x[i] = s / l[i][i];
            trace += x[i] * x[i];
        }
    }
    return 1 / trace;
}

template <int K>
void solve(const double (&l)[K][K], double (&x)[K]) {
    for (int i = 0; i < K; ++i) {
        for (int k = 0; k < i; ++k) x[i] -= l[i][k] * x[k];
        x[i] /= l[i][i];
    }
    for (int i = K - 1; i >= 0; --i) {
        for (int k = i + 1; k < K; ++k) x[i] -= l[k][i] * x[k];
        x[i] /= l[i][i];
    }
}

/// x and y first, then the quadratic terms.
template <HeightForm form>
void terms(double x, double y, double z, double (&m)[terms_of(form)]) {
    const double rr = x * x + y * y, c = std::min((rr + z * z) / std::max(rr, 1e-12), 4.0);
    m[0] = x, m[1] = y, m[2] = c * x * x, m[3] = c * x * y, m[4] = c * y * y;
    if constexpr (form == HeightForm::cubic) m[5] = x * x * x, m[6] = x * x * y, m[7] = x * y * y, m[8] = y * y * y;
    if constexpr (form == HeightForm::wide) m[5] = 1;
}

struct Axes {
    dvec3 t, b, n;
};
Axes axes_of(dvec3 n) {
    const dvec3 t = normalize_or(cross(n, std::fabs(n.x) < 0.8 ? dvec3{1, 0, 0} : dvec3{0, 1, 0}), dvec3{0, 0, 1});
    return {t, cross(n, t), n};
}

template <HeightForm form>
Equations<terms_of(form)> equations_of(std::span<const dvec3> neighbors, const Axes& axes) {
    constexpr int K = terms_of(form);
    Equations<K> e;
    for (const dvec3& d : neighbors) {
        const double x = dot(d, axes.t), y = dot(d, axes.b), z = dot(d, axes.n);
        const double square = x * x + y * y + z * z + 1e-12;
        const double w = form == HeightForm::wide ? 1 : 1 / (square * square);
        double m[K];
        terms<form>(x, y, z, m);
        for (int i = 0; i < K; ++i) {
            const double q = w * m[i];
            e.r[i] += q * z;
            for (int j = 0; j <= i; ++j) e.a[i][j] += q * m[j];
        }
        e.heights += w * z * z, e.weight += w;
    }
    if constexpr (form == HeightForm::wide) e.a[K - 1][K - 1] += 1;  // the place itself
    return e;
}

/// The coefficients. A little is added to the diagonal, so that what neighbors leave open stays small.
/// @return the rank of HeightFit
template <int K>
double coefficients(const Equations<K>& e, double (&c)[K]) {
    double scale[K], scaled[K][K] = {}, firm[K][K] = {};
    for (int i = 0; i < K; ++i) scale[i] = 1 / std::sqrt(e.a[i][i] + 1e-300);
    for (int i = 0; i < K; ++i) {
        for (int j = 0; j <= i; ++j) firm[i][j] = scaled[i][j] = e.a[i][j] * scale[i] * scale[j];
        firm[i][i] += (i < 2 ? 1e-7 : 1e-4) + 1e-12 * e.weight * scale[i] * scale[i];
        c[i] = e.r[i] * scale[i];
    }
    if (!factor(firm)) {
        std::fill(c, c + K, 0.0);
        return 0;
    }
    solve(firm, c);
    for (int i = 0; i < K; ++i) c[i] *= scale[i];
    return factor(scaled) ? reciprocal_trace(scaled) : 0;
}

/// Sum of weight times the square of what the first `used` terms leave of the heights.
template <int K>
double left_by(const Equations<K>& e, const double (&c)[K], int used) {
    double left = e.heights;
    for (int i = 0; i < used; ++i) {
        left -= 2 * c[i] * e.r[i];
        for (int j = 0; j < used; ++j) left += c[i] * c[j] * (j <= i ? e.a[i][j] : e.a[j][i]);
    }
    return std::max(left, 0.0);
}

template <HeightForm form>
HeightFit fit(std::span<const dvec3> neighbors, dvec3 normal) {
    constexpr int K = terms_of(form), rounds = form == HeightForm::wide ? 3 : 1;  // more rounds gain nothing
    HeightFit out{.normal = normal};
    for (int round = 0; round < rounds; ++round) {
        const Axes axes = axes_of(out.normal);
        const Equations<K> e = equations_of<form>(neighbors, axes);
        double c[K];
        out.rank = coefficients(e, c);
        out.weight = e.weight;
        out.residual = left_by(e, c, K), out.bent = left_by(e, c, 2);
        out.normal = normalize_or(axes.n - axes.t * c[0] - axes.b * c[1], normal);
    }
    return out;
}

}  // namespace

HeightFit fit_height(std::span<const dvec3> neighbors, dvec3 normal, HeightForm form) {
    switch (form) {
        case HeightForm::quadric:
            return fit<HeightForm::quadric>(neighbors, normal);
        case HeightForm::cubic:
            return fit<HeightForm::cubic>(neighbors, normal);
        case HeightForm::wide:
            break;
    }
    return fit<HeightForm::wide>(neighbors, normal);
}

}  // namespace rakelight::geometry
