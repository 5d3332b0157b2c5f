// SPDX-License-Identifier: Apache-2.0
// The GLSL prelude (3.30 core and ES 3.00): the vocabulary of the shared code that GLSL lacks, with the edge cases of
// math/wide.h, the scalar and wide C++ prelude. Exception: min, max and clamp of NaN depend on the GPU. The loader puts
// #version (and for ES the precision) before it.
#define RL_FN
#define RL_IN(type) type
#define RL_INOUT(type) inout type
#define real float
#define mask bool
#define RL_MAP_FN
#define RL_CAN_SKIP(lanes_that_need_it) false  // a branch per pixel costs more than it saves
#ifdef RL_TANGENTS_ARE_SOUND  // the mesh has checked tangents: degenerate interpolated ones are handled later
#define RL_NEEDS_NO_FALLBACK(mask_of_sound_lanes) true
#else
#define RL_NEEDS_NO_FALLBACK(mask_of_sound_lanes) all_lanes(mask_of_sound_lanes)
#endif

bool any_lane(bool m) { return m; }
bool all_lanes(bool m) { return m; }
bool no_lane(bool m) { return !m; }
float select(bool m, float a, float b) { return m ? a : b; }
vec2 select(bool m, vec2 a, vec2 b) { return m ? a : b; }
vec3 select(bool m, vec3 a, vec3 b) { return m ? a : b; }
vec4 select(bool m, vec4 a, vec4 b) { return m ? a : b; }

float reciprocal(float x) { return 1.0f / x; }
float copy_sign(float x, float s) { return uintBitsToFloat((floatBitsToUint(x) & 0x7fffffffu) | (floatBitsToUint(s) & 0x80000000u)); }
float log2_coarse(float x) { return log2(clamp(x, 1.17549435e-38f, 3.40282347e38f)); }
float safe_sqrt(float x) { return x > 0.0f ? sqrt(x) : 0.0f; }  // 0 for negative x and NaN

// x^y for x > 0; 0 for x <= 0 and NaN, for any y.
float pow_positive(float x, float y) { return x >= 1.17549435e-38f ? pow(x, y) : 0.0f; }

// Unit vector of a, or fallback where the squared length is NaN, below 2^-126 or not finite.
vec3 safe_normalize_or(vec3 a, vec3 fallback)
{
    float squared = dot(a, a);
    return squared >= 1.17549435e-38f && squared <= 3.40282347e38f ? a * (1.0f / sqrt(squared)) : fallback;
}
vec3 safe_normalize(vec3 a) { return safe_normalize_or(a, vec3(0.0f, 0.0f, 1.0f)); }
