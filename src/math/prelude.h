// SPDX-License-Identifier: Apache-2.0
// The C++ preludes of the lighting text, scalar and wide: the words of math/wide.h, whose flavour RL_ISA is the
// difference. Their GLSL brother is prelude.glsl. To be included inside the namespace that takes the words; no include
// guard.
#define RL_FN [[gnu::always_inline]] inline  // structs of wide vectors would travel through memory
#define RL_IN(type) const type&              // a struct that is only read: GLSL's `in`, without a copy
#define RL_INOUT(type) type&                 // a struct that is changed: GLSL's `inout`
// A function that reads maps. Maps is a type of the includer's, with functions sample_height(maps, uv, level) and so on beside
// it: lighting/maps.glsl is their GLSL brother.
#define RL_MAP_FN         \
    template <class Maps> \
    RL_FN
// Whether work for lanes of the mask can be skipped: no lane is set.
#define RL_CAN_SKIP(lanes_that_need_it) no_lane(lanes_that_need_it)
// Whether a fallback for lanes without the mask can be skipped.
#define RL_NEEDS_NO_FALLBACK(mask_of_sound_lanes) all_lanes(mask_of_sound_lanes)
RL_USE_WIDE;
