// SPDX-License-Identifier: Apache-2.0
// The C++ preludes of the shared code, scalar and wide: the vocabulary of math/wide.h in flavor RL_ISA. The GLSL
// counterpart is prelude.glsl. Include it inside the target namespace; there is no include guard.
#define RL_FN [[gnu::always_inline]] inline  // structs of wide vectors would be passed in memory
#define RL_IN(type) const type&              // a read-only struct: `in` in GLSL, without a copy
#define RL_INOUT(type) type&                 // a modified struct: `inout` in GLSL
// A function that samples textures. The includer defines the type Maps with functions such as sample_height(maps, uv,
// level); the GLSL counterpart is lighting/maps.glsl.
#define RL_MAP_FN         \
    template <class Maps> \
    RL_FN
// Whether work for lanes of the mask can be skipped: no lane is set.
#define RL_CAN_SKIP(lanes_that_need_it) no_lane(lanes_that_need_it)
// Whether a fallback for lanes without the mask can be skipped.
#define RL_NEEDS_NO_FALLBACK(mask_of_sound_lanes) all_lanes(mask_of_sound_lanes)
RL_USE_WIDE;
