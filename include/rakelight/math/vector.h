// SPDX-License-Identifier: Apache-2.0
// Vectors, matrices and quaternions as plain structs. Float types are vec2, vec3, vec4, mat3, mat4. Double types are
// dvec2, dvec3, dvec4, dmat3, dmat4, dquat. Vectors are columns. A matrix is an array of columns: the element in row r
// and column c is m[c][r]. Coordinates are right-handed, +Y is up, and cameras look along -Z.
#pragma once
#include <cstddef>

namespace rakelight {

/// Two numbers.
template <class T>
struct Vector2 {
    T x{}, y{};  ///< components
    constexpr T& operator[](std::size_t i) { return i == 0 ? x : y; }
    constexpr const T& operator[](std::size_t i) const { return i == 0 ? x : y; }
    bool operator==(const Vector2&) const = default;
};

/// Three numbers.
template <class T>
struct Vector3 {
    T x{}, y{}, z{};  ///< components
    constexpr T& operator[](std::size_t i) { return i == 0 ? x : i == 1 ? y : z; }
    constexpr const T& operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }
    bool operator==(const Vector3&) const = default;
};

/// Four numbers.
template <class T>
struct Vector4 {
    T x{}, y{}, z{}, w{};  ///< components
    constexpr T& operator[](std::size_t i) { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
    constexpr const T& operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
    /// The first three.
    constexpr Vector3<T> xyz() const { return {x, y, z}; }
    bool operator==(const Vector4&) const = default;
};

/// Four columns. The default is the identity.
template <class T>
struct Matrix4 {
    Vector4<T> columns[4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    constexpr Vector4<T>& operator[](std::size_t c) { return columns[c]; }
    constexpr const Vector4<T>& operator[](std::size_t c) const { return columns[c]; }
    bool operator==(const Matrix4&) const = default;
};

/// Three columns. The default is the identity.
template <class T>
struct Matrix3 {
    Vector3<T> columns[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    constexpr Vector3<T>& operator[](std::size_t c) { return columns[c]; }
    constexpr const Vector3<T>& operator[](std::size_t c) const { return columns[c]; }
    bool operator==(const Matrix3&) const = default;
};

/// Rotation x i + y j + z k + w. The default is no rotation.
template <class T>
struct Quaternion {
    T x{}, y{}, z{}, w{1};  ///< see above
    bool operator==(const Quaternion&) const = default;
};

using vec2 = Vector2<float>;
using vec3 = Vector3<float>;
using vec4 = Vector4<float>;
using mat3 = Matrix3<float>;
using mat4 = Matrix4<float>;
using dvec2 = Vector2<double>;
using dvec3 = Vector3<double>;
using dvec4 = Vector4<double>;
using dmat3 = Matrix3<double>;
using dmat4 = Matrix4<double>;
using dquat = Quaternion<double>;

static_assert(sizeof(vec2) == 8 && sizeof(vec3) == 12 && sizeof(vec4) == 16 && sizeof(mat4) == 64);
static_assert(sizeof(dvec3) == 24 && sizeof(dmat4) == 128);

inline constexpr double pi = 3.14159265358979323846;  ///< half a turn [rad]
/// From degrees to radians.
constexpr double radians(double degrees) { return degrees * (pi / 180.0); }
/// From radians to degrees.
constexpr double degrees(double radians) { return radians * (180.0 / pi); }

}  // namespace rakelight
