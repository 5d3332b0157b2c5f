// SPDX-License-Identifier: Apache-2.0
#include "image/tone_curves.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include <rakelight/error.h>

#include "base/assert.h"
#include "image/tone_kernel.h"
#include "math/functions.h"

namespace rakelight {
namespace {

/// Sobotka's sigmoid through (0, 0), (1, 1) and the pivot, where its slope is 2: powers 3 below and 3.25 above.
double agx_sigmoid(double x) {
    constexpr double pivot = 10 / 16.5, middle = 0.5, slope = 2;
    const bool is_above = x > pivot;
    const double power = is_above ? 3.25 : 3.0, span = is_above ? 1 - pivot : pivot;
    // a: such that the curve ends at 0 or 1: middle + slope (end - pivot) / (1 + a span^power)^(1 / power)
    const double a = (math::pow(slope * span / middle, power) - 1) / math::pow(span, power);
    const double from = is_above ? x - pivot : pivot - x;
    if (!(from > 0)) return middle;
    const double rise = slope * from / math::pow(1 + a * math::pow(from, power), 1 / power);
    return std::clamp(is_above ? middle + rise : middle - rise, 0.0, 1.0);
}

AgxCurves make_agx_curves() {
    AgxCurves out;
    const double low_ev = math::log2(0.18) - 10, high_ev = math::log2(0.18) + 6.5;
    for (std::uint32_t i = 0; i <= AgxCurves::light_pieces; ++i) {
        const float v =
            std::bit_cast<float>(std::bit_cast<std::uint32_t>(AgxCurves::lowest) + (i << AgxCurves::piece_bits));
        const double x = (math::log2(double(v)) - low_ev) / (high_ev - low_ev);
        out.contrast[i] = float(agx_sigmoid(std::clamp(x, 0.0, 1.0)));
    }
    for (std::uint32_t i = 0; i <= AgxCurves::power_pieces; ++i)
        out.power[i] = i == 0 ? 0.0f : float(math::pow(double(i) / AgxCurves::power_pieces, 2.2));
    return out;
}

const AgxCurves& agx_curves() {
    static const AgxCurves curves = make_agx_curves();
    return curves;
}

ToneNumber number_of(ToneMapping mapping) {
    switch (mapping) {
        case ToneMapping::none:
            return tone_none;
        case ToneMapping::reinhard:
            return tone_reinhard;
        case ToneMapping::neutral:
            return tone_neutral;
        case ToneMapping::aces:
            return tone_aces;
        case ToneMapping::agx:
            return tone_agx;
    }
    return tone_none;
}

float gain_of(double exposure_ev) {
    if (!(std::abs(exposure_ev) <= most_exposure_ev))
        throw Error(ErrorCode::usage, "the exposure must be from -32 to 32 EV");
    return float(math::exp2(exposure_ev));
}

}  // namespace

ToneCurve::ToneCurve(const ToneSettings& settings)
    : mapping_(settings.mapping),
      gain_(gain_of(settings.exposure_ev)),
      is_identity_(mapping_ == ToneMapping::none && gain_ == 1) {}

vec3 ToneCurve::operator()(vec3 light) const {
    const AgxCurves* const curves = mapping_ == ToneMapping::agx ? &agx_curves() : nullptr;
    float mapped[3];
    tone::scalar::map_tone(curves, number_of(mapping_), gain_, {light.x, light.y, light.z}, mapped);
    return {mapped[0], mapped[1], mapped[2]};
}

void ToneCurve::apply(std::span<const vec4> in, std::span<vec4> out) const {
    RL_ASSERT(in.size() == out.size(), "rows of one length");
    vec3 before{};  // most of a background is one color
    vec3 mapped = (*this)(before);
    for (std::size_t i = 0; i < in.size(); ++i) {
        const vec4 color = in[i];  // which may be out[i]
        if (!(color.xyz() == before)) before = color.xyz(), mapped = (*this)(before);
        out[i] = {mapped.x, mapped.y, mapped.z, color.w};
    }
}

}  // namespace rakelight
