// SPDX-License-Identifier: Apache-2.0
#include "image/tone_kernel.h"

#include "math/wide.h"

namespace rakelight::tone::RL_ISA {
namespace {

#include "math/prelude.h"

struct Maps {
    const AgxCurves* curves;
};

real agx_contrast(const Maps& maps, real light) {
    constexpr int bits = AgxCurves::piece_bits;
    const integer above =
        bits_of(clamp(light, real(AgxCurves::lowest), real(AgxCurves::highest))) - bits_of(AgxCurves::lowest);
    const integer piece = min(shift_right_logical(above, bits), integer(int32_t(AgxCurves::light_pieces) - 1));
    const real t = to_real(above & integer((1 << bits) - 1)) * (1.0f / float(1 << bits));
    const real from = gather(maps.curves->contrast, piece), to = gather(maps.curves->contrast + 1, piece);
    return from + (to - from) * t;
}

real agx_power(const Maps& maps, real display) {
    constexpr auto pieces = int32_t(AgxCurves::power_pieces);
    const real at = clamp(display, real(0.0f), real(1.0f)) * real(float(pieces));
    const integer piece = min(to_int(at), integer(pieces - 1));
    const real from = gather(maps.curves->power, piece), to = gather(maps.curves->power + 1, piece);
    return from + (to - from) * (at - to_real(piece));
}

// clang-format off
#include "image/tone.glsl"
// clang-format on

static_assert(rakelight::tone_none == RL_TONE_NONE && rakelight::tone_reinhard == RL_TONE_REINHARD &&
              rakelight::tone_neutral == RL_TONE_NEUTRAL && rakelight::tone_aces == RL_TONE_ACES &&
              rakelight::tone_agx == RL_TONE_AGX);

}  // namespace

void map_tone(const AgxCurves* curves, int32_t mapping, float gain, const float (&light)[3], float (&mapped)[3]) {
    const vec3 c = tone_curve(Maps{curves}, mapping, vec3(light[0], light[1], light[2]), gain);
    mapped[0] = c.x, mapped[1] = c.y, mapped[2] = c.z;
}

}  // namespace rakelight::tone::RL_ISA
