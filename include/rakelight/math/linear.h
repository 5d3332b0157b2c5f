// SPDX-License-Identifier: Apache-2.0
// Arithmetic on the vectors and matrices of <rakelight/math/vector.h>: operators, products, inverse, look-at, projections.
// Only + - * / and sqrt, so results are bit-identical on all machines. Trigonometric functions are the library's own.
#pragma once
#include <cmath>
#include <limits>

#include <rakelight/base/export.h>
#include <rakelight/math/vector.h>

namespace rakelight {

template <class T>
constexpr Vector2<T> operator+(Vector2<T> a, Vector2<T> b) {
    return {a.x + b.x, a.y + b.y};
}
template <class T>
constexpr Vector2<T> operator-(Vector2<T> a, Vector2<T> b) {
    return {a.x - b.x, a.y - b.y};
}
template <class T>
constexpr Vector2<T> operator*(Vector2<T> a, T s) {
    return {a.x * s, a.y * s};
}
template <class T>
constexpr Vector3<T> operator+(Vector3<T> a, Vector3<T> b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
constexpr Vector3<T> operator-(Vector3<T> a, Vector3<T> b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
constexpr Vector3<T> operator-(Vector3<T> a) {
    return {-a.x, -a.y, -a.z};
}
template <class T>
constexpr Vector3<T> operator*(Vector3<T> a, Vector3<T> b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class T>
constexpr Vector3<T> operator*(Vector3<T> a, T s) {
    return {a.x * s, a.y * s, a.z * s};
}
template <class T>
constexpr Vector3<T> operator*(T s, Vector3<T> a) {
    return a * s;
}
template <class T>
constexpr Vector3<T> operator/(Vector3<T> a, T s) {
    return {a.x / s, a.y / s, a.z / s};
}
template <class T>
constexpr Vector3<T>& operator+=(Vector3<T>& a, Vector3<T> b) {
    return a = a + b;
}
template <class T>
constexpr Vector4<T> operator+(Vector4<T> a, Vector4<T> b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
template <class T>
constexpr Vector4<T> operator-(Vector4<T> a, Vector4<T> b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w};
}
template <class T>
constexpr Vector4<T> operator*(Vector4<T> a, T s) {
    return {a.x * s, a.y * s, a.z * s, a.w * s};
}

/// Scalar product.
template <class T>
constexpr T dot(Vector2<T> a, Vector2<T> b) {
    return a.x * b.x + a.y * b.y;
}
/// Scalar product.
template <class T>
constexpr T dot(Vector3<T> a, Vector3<T> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Scalar product.
template <class T>
constexpr T dot(Vector4<T> a, Vector4<T> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}
/// Vector product.
template <class T>
constexpr Vector3<T> cross(Vector3<T> a, Vector3<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Euclidean length.
template <class T>
T length(Vector3<T> a) {
    return std::sqrt(dot(a, a));
}
/// Component-wise minimum.
template <class T>
Vector3<T> min(Vector3<T> a, Vector3<T> b) {
    return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z};
}
/// Component-wise maximum.
template <class T>
Vector3<T> max(Vector3<T> a, Vector3<T> b) {
    return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z};
}
/// Whether all components are finite.
template <class T>
bool is_finite(Vector3<T> a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Unit vector in the direction of `a`, without overflow or underflow for any finite length. If `a` is zero or
/// non-finite, the result is `fallback`.
template <class T>
Vector3<T> normalize_or(Vector3<T> a, Vector3<T> fallback) {
    const T largest = std::fmax(std::fmax(std::fabs(a.x), std::fabs(a.y)), std::fabs(a.z));
    if (!(largest > T(0)) || !(largest <= std::numeric_limits<T>::max()) || !is_finite(a)) return fallback;
    const Vector3<T> scaled = a / largest;
    return scaled / length(scaled);
}

/// Another type of number.
template <class To, class From>
constexpr Vector3<To> cast(Vector3<From> a) {
    return {To(a.x), To(a.y), To(a.z)};
}
/// Another type of number.
template <class To, class From>
constexpr Vector4<To> cast(Vector4<From> a) {
    return {To(a.x), To(a.y), To(a.z), To(a.w)};
}
/// Another type of number.
template <class To, class From>
constexpr Matrix4<To> cast(const Matrix4<From>& m) {
    return {{cast<To>(m[0]), cast<To>(m[1]), cast<To>(m[2]), cast<To>(m[3])}};
}

template <class T>
constexpr Vector4<T> operator*(const Matrix4<T>& m, Vector4<T> v) {
    return m[0] * v.x + m[1] * v.y + m[2] * v.z + m[3] * v.w;
}
template <class T>
constexpr Vector3<T> operator*(const Matrix3<T>& m, Vector3<T> v) {
    return m[0] * v.x + m[1] * v.y + m[2] * v.z;
}
template <class T>
constexpr Matrix4<T> operator*(const Matrix4<T>& a, const Matrix4<T>& b) {
    return {{a * b[0], a * b[1], a * b[2], a * b[3]}};
}
template <class T>
constexpr Matrix3<T> operator*(const Matrix3<T>& a, const Matrix3<T>& b) {
    return {{a * b[0], a * b[1], a * b[2]}};
}

/// An affine matrix (last row 0 0 0 1) times a point.
template <class T>
constexpr Vector3<T> transform_point(const Matrix4<T>& m, Vector3<T> p) {
    return {m[0].x * p.x + m[1].x * p.y + m[2].x * p.z + m[3].x, m[0].y * p.x + m[1].y * p.y + m[2].y * p.z + m[3].y,
            m[0].z * p.x + m[1].z * p.y + m[2].z * p.z + m[3].z};
}
/// An affine matrix times a direction: without the translation.
template <class T>
constexpr Vector3<T> transform_direction(const Matrix4<T>& m, Vector3<T> d) {
    return {m[0].x * d.x + m[1].x * d.y + m[2].x * d.z, m[0].y * d.x + m[1].y * d.y + m[2].y * d.z,
            m[0].z * d.x + m[1].z * d.y + m[2].z * d.z};
}

/// The first three rows and columns.
template <class T>
constexpr Matrix3<T> upper_left(const Matrix4<T>& m) {
    return {{m[0].xyz(), m[1].xyz(), m[2].xyz()}};
}
/// The determinant. It is negative for mirroring matrices.
template <class T>
constexpr T determinant(const Matrix3<T>& m) {
    return dot(m[0], cross(m[1], m[2]));
}

/// Cofactor matrix: the inverse transpose times the determinant. It transforms normals, also for a singular m:
/// cofactor(m) * cross(a, b) == cross(m * a, m * b). If m mirrors, negate the result to keep normals outward.
template <class T>
constexpr Matrix3<T> cofactor(const Matrix3<T>& m) {
    return {{cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])}};
}

template <class T>
constexpr Matrix4<T> transpose(const Matrix4<T>& m) {
    Matrix4<T> r;
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t i = 0; i < 4; ++i) r[c][i] = m[i][c];
    return r;
}

/// Translation matrix.
template <class T>
constexpr Matrix4<T> translation(Vector3<T> t) {
    return {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {t.x, t.y, t.z, 1}}};
}
/// Scaling matrix.
template <class T>
constexpr Matrix4<T> scaling(Vector3<T> s) {
    return {{{s.x, 0, 0, 0}, {0, s.y, 0, 0}, {0, 0, s.z, 0}, {0, 0, 0, 1}}};
}

/// Translation * rotation * scale. The quaternion is normalized; a zero quaternion is the identity.
RL_API dmat4 compose(dvec3 translation, dquat rotation, dvec3 scale);

/// Inverse of an affine matrix. If the matrix is singular, returns false and leaves `out` unchanged.
RL_API bool inverse_affine(const dmat4& m, dmat4& out);

/// The transform from camera space to world space, for a camera at `eye` that looks at `target` along its -Z axis. If
/// the target is at the eye, or `up` is parallel to the view direction, a fixed direction is used instead. So the
/// result is always a rigid transform.
RL_API dmat4 look_at(dvec3 eye, dvec3 target, dvec3 up);

/// Perspective projection to clip space, -w <= x, y, z <= w. The camera looks along -Z.
/// @param vertical_fov_rad  0..pi, both exclusive
/// @param aspect  width / height
/// @param z_near  > 0
/// @param z_far  may be infinity
RL_API dmat4 perspective(double vertical_fov_rad, double aspect, double z_near, double z_far);
/// Orthographic projection to clip space.
/// @param half_height  > 0: half of the visible height
RL_API dmat4 orthographic(double half_height, double aspect, double z_near, double z_far);

}  // namespace rakelight
