// SPDX-License-Identifier: Apache-2.0
#include "math/linear.h"

#include <cmath>

namespace rakelight {

namespace {

/// Rotation matrix of the normalized quaternion; zero and non-finite ones give the identity.
dmat3 rotation_matrix(dquat q) {
    const double largest =
        std::fmax(std::fmax(std::fabs(q.x), std::fabs(q.y)), std::fmax(std::fabs(q.z), std::fabs(q.w)));
    if (!(largest > 0.0) || !std::isfinite(q.x) || !std::isfinite(q.y) || !std::isfinite(q.z) || !std::isfinite(q.w))
        return {};
    q = {q.x / largest, q.y / largest, q.z / largest, q.w / largest};
    const double s = 2.0 / (q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    return {{{1 - s * (q.y * q.y + q.z * q.z), s * (q.x * q.y + q.z * q.w), s * (q.x * q.z - q.y * q.w)},
             {s * (q.x * q.y - q.z * q.w), 1 - s * (q.x * q.x + q.z * q.z), s * (q.y * q.z + q.x * q.w)},
             {s * (q.x * q.z + q.y * q.w), s * (q.y * q.z - q.x * q.w), 1 - s * (q.x * q.x + q.y * q.y)}}};
}

constexpr dvec4 extended(dvec3 v, double w) { return {v.x, v.y, v.z, w}; }

}  // namespace

dmat4 compose(dvec3 t, dquat rotation, dvec3 scale) {
    const dmat3 r = rotation_matrix(rotation);
    return {{extended(r[0] * scale.x, 0), extended(r[1] * scale.y, 0), extended(r[2] * scale.z, 0), extended(t, 1)}};
}

bool inverse_affine(const dmat4& m, dmat4& out) {
    dmat3 a = upper_left(m);
    // Scaled to entries of at most 1, so that a model in micrometers is not singular.
    double largest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        if (!is_finite(a[c])) return false;
        for (std::size_t r = 0; r < 3; ++r) largest = std::fmax(largest, std::fabs(a[c][r]));
    }
    if (!(largest > 0.0) || !is_finite(m[3].xyz())) return false;
    for (std::size_t c = 0; c < 3; ++c) a[c] = a[c] / largest;
    const double det = determinant(a);
    const dmat3 cof = cofactor(a);
    dmat3 inverse;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t r = 0; r < 3; ++r) inverse[c][r] = cof[r][c] / det / largest;
    for (std::size_t c = 0; c < 3; ++c)
        if (!is_finite(inverse[c])) return false;
    const dvec3 t = -(inverse * m[3].xyz());
    if (!is_finite(t)) return false;
    out = {{extended(inverse[0], 0), extended(inverse[1], 0), extended(inverse[2], 0), extended(t, 1)}};
    return true;
}

dmat4 look_at(dvec3 eye, dvec3 target, dvec3 up) {
    const dvec3 back = normalize_or(eye - target, dvec3{0, 0, 1});
    const dvec3 wanted_up = normalize_or(up, dvec3{0, 1, 0});
    dvec3 right = cross(wanted_up, back);
    // If `up` is within 1e-6 rad of the view, use the axis most perpendicular to the view.
    if (!(dot(right, right) > 1e-12)) {
        const double x = std::fabs(back.x), y = std::fabs(back.y), z = std::fabs(back.z);
        const dvec3 across = z <= x && z <= y ? dvec3{0, 0, 1} : x <= y ? dvec3{1, 0, 0} : dvec3{0, 1, 0};
        right = cross(across, back);
    }
    right = normalize_or(right, dvec3{1, 0, 0});
    return {{extended(right, 0), extended(cross(back, right), 0), extended(back, 0), extended(eye, 1)}};
}

dmat4 orthographic(double half_height, double aspect, double near, double far) {
    const double depth = far - near;
    return {{{1 / (half_height * aspect), 0, 0, 0},
             {0, 1 / half_height, 0, 0},
             {0, 0, -2 / depth, 0},
             {0, 0, -(far + near) / depth, 1}}};
}

}  // namespace rakelight
