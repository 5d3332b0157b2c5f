// SPDX-License-Identifier: Apache-2.0
// The tone curves' text, compiled as scalar words (rl_add_flavour), for ordinary code. C headers only.
#pragma once
#include <stdint.h>

namespace rakelight {

/// AgX's curves as tables of straight pieces: of light, 64 an octave from 2^-13 to 2^5, keyed by the upper bits of the
/// float; of display values, 4096 to 1. Error of the two together under 2e-5 of the value: a two-hundredth of an 8-bit
/// code.
struct AgxCurves {
    static constexpr float lowest = 0x1p-13f, highest = 0x1p5f;  ///< beyond 10 EV under and 6.5 EV over 0.18
    static constexpr int piece_bits = 17;
    static constexpr uint32_t light_pieces = (5 + 13) * 64, power_pieces = 4096;
    float contrast[light_pieces + 1];  ///< light -> 0..1 as displayed
    float power[power_pieces + 1];     ///< display value -> light: the power 2.2
};

/// RL_TONE_... of tone.glsl.
enum ToneNumber : int32_t { tone_none, tone_reinhard, tone_neutral, tone_aces, tone_agx };

namespace tone::scalar {
/// @param mapping  ToneNumber
/// @param curves used by RL_TONE_AGX only
void map_tone(const AgxCurves* curves, int32_t mapping, float gain, const float (&light)[3], float (&mapped)[3]);
}  // namespace tone::scalar

}  // namespace rakelight
