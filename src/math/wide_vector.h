// SPDX-License-Identifier: Apache-2.0
// vec2, vec3, vec4 of `real`, one source for all flavors: the vector types of the shared lighting code. Sums run x, y,
// z, w.
#pragma once

namespace rakelight::wide::RL_ISA {

struct vec2 {
    real x, y;
    vec2() = default;
    vec2(real x_, real y_) : x(x_), y(y_) {}
    explicit vec2(real s) : x(s), y(s) {}
};
struct vec3 {
    real x, y, z;
    vec3() = default;
    vec3(real x_, real y_, real z_) : x(x_), y(y_), z(z_) {}
    explicit vec3(real s) : x(s), y(s), z(s) {}
};
struct vec4 {
    real x, y, z, w;
    vec4() = default;
    vec4(real x_, real y_, real z_, real w_) : x(x_), y(y_), z(z_), w(w_) {}
    explicit vec4(real s) : x(s), y(s), z(s), w(s) {}
};

inline vec2 operator+(vec2 a, vec2 b) { return vec2(a.x + b.x, a.y + b.y); }
inline vec2 operator-(vec2 a, vec2 b) { return vec2(a.x - b.x, a.y - b.y); }
inline vec2 operator*(vec2 a, vec2 b) { return vec2(a.x * b.x, a.y * b.y); }
inline vec2 operator/(vec2 a, vec2 b) { return vec2(a.x / b.x, a.y / b.y); }
inline vec2 operator*(vec2 a, real s) { return vec2(a.x * s, a.y * s); }
inline vec2 operator*(real s, vec2 a) { return a * s; }
inline vec2 operator/(vec2 a, real s) { return vec2(a.x / s, a.y / s); }
inline vec2 operator-(vec2 a) { return vec2(-a.x, -a.y); }
inline vec2& operator+=(vec2& a, vec2 b) { return a = a + b; }

inline vec3 operator+(vec3 a, vec3 b) { return vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
inline vec3 operator-(vec3 a, vec3 b) { return vec3(a.x - b.x, a.y - b.y, a.z - b.z); }
inline vec3 operator*(vec3 a, vec3 b) { return vec3(a.x * b.x, a.y * b.y, a.z * b.z); }
inline vec3 operator/(vec3 a, vec3 b) { return vec3(a.x / b.x, a.y / b.y, a.z / b.z); }
inline vec3 operator*(vec3 a, real s) { return vec3(a.x * s, a.y * s, a.z * s); }
inline vec3 operator*(real s, vec3 a) { return a * s; }
inline vec3 operator/(vec3 a, real s) { return vec3(a.x / s, a.y / s, a.z / s); }
inline vec3 operator-(vec3 a) { return vec3(-a.x, -a.y, -a.z); }
inline vec3& operator+=(vec3& a, vec3 b) { return a = a + b; }

inline vec4 operator+(vec4 a, vec4 b) { return vec4(a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w); }
inline vec4 operator-(vec4 a, vec4 b) { return vec4(a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w); }
inline vec4 operator*(vec4 a, vec4 b) { return vec4(a.x * b.x, a.y * b.y, a.z * b.z, a.w * b.w); }
inline vec4 operator/(vec4 a, vec4 b) { return vec4(a.x / b.x, a.y / b.y, a.z / b.z, a.w / b.w); }
inline vec4 operator*(vec4 a, real s) { return vec4(a.x * s, a.y * s, a.z * s, a.w * s); }
inline vec4 operator*(real s, vec4 a) { return a * s; }
inline vec4 operator/(vec4 a, real s) { return vec4(a.x / s, a.y / s, a.z / s, a.w / s); }
inline vec4 operator-(vec4 a) { return vec4(-a.x, -a.y, -a.z, -a.w); }
inline vec4& operator+=(vec4& a, vec4 b) { return a = a + b; }

inline vec2 select(mask m, vec2 a, vec2 b) { return vec2(select(m, a.x, b.x), select(m, a.y, b.y)); }
inline vec3 select(mask m, vec3 a, vec3 b) {
    return vec3(select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z));
}
inline vec4 select(mask m, vec4 a, vec4 b) {
    return vec4(select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z), select(m, a.w, b.w));
}
inline vec3 min(vec3 a, vec3 b) { return vec3(min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)); }
inline vec3 max(vec3 a, vec3 b) { return vec3(max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)); }
inline vec2 mix(vec2 a, vec2 b, real t) { return a + (b - a) * t; }
inline vec3 mix(vec3 a, vec3 b, real t) { return a + (b - a) * t; }
inline vec4 mix(vec4 a, vec4 b, real t) { return a + (b - a) * t; }

inline real dot(vec2 a, vec2 b) { return a.x * b.x + a.y * b.y; }
inline real dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline real dot(vec4 a, vec4 b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }
inline vec3 cross(vec3 a, vec3 b) { return vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x); }
inline real length(vec2 a) { return sqrt(dot(a, a)); }
inline real length(vec3 a) { return sqrt(dot(a, a)); }
inline vec3 normalize(vec3 a) { return a * reciprocal(length(a)); }  ///< not for zero vectors: see safe_normalize

/// Unit vector of a, or `fallback` if the direction cannot be computed in float: the squared length is NaN, below
/// 2^-126 (|a| under 1.1e-19) or over FLT_MAX (|a| over 1.8e19).
inline vec3 safe_normalize_or(vec3 a, vec3 fallback) {
    const real squared = dot(a, a);
    const mask has_direction = (squared >= real(1.17549435e-38f)) && (squared <= real(3.40282347e38f));
    const vec3 unit = a * reciprocal(sqrt(squared));
    return all_lanes(has_direction) ? unit : select(has_direction, unit, fallback);
}
/// The same with fallback (0, 0, 1).
inline vec3 safe_normalize(vec3 a) { return safe_normalize_or(a, vec3(real(0.0f), real(0.0f), real(1.0f))); }

}  // namespace rakelight::wide::RL_ISA
