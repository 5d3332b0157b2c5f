// SPDX-License-Identifier: Apache-2.0
#include "image/tone_curves.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include <rakelight/base/error.h>

#include "base/assert.h"
#include "image/tone_kernel.h"
#include "math/functions.h"

namespace rakelight {
namespace {

/// Sobotka's sigmoid through (0, 0), (1, 1) and the pivot with slope 2: powers 3 below and 3.25 above.
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
    if (!(std::abs(exposure_ev) <= max_exposure_ev))
        throw Error(ErrorCode::usage, "the exposure must be from -32 to 32 EV");
    return float(math::exp2(exposure_ev));
}

}  // namespace

ToneCurve::ToneCurve(const ToneSettings& settings, vec4 behind)
    : mapping_(settings.mapping),
      gain_(gain_of(settings.exposure_ev)),
      behind_(behind),
      is_identity_(mapping_ == ToneMapping::none && gain_ == 1 && !(behind_.w > 0)) {}

vec3 ToneCurve::operator()(vec3 light) const {
    const AgxCurves* const curves = mapping_ == ToneMapping::agx ? &agx_curves() : nullptr;
    float mapped[3];
    tone::scalar::map_tone(curves, number_of(mapping_), gain_, {light.x, light.y, light.z}, mapped);
    return {mapped[0], mapped[1], mapped[2]};
}

/// Fixed-point iteration: each component is scaled by the square root of its relative error. Curves increase in every
/// component at most quadratically.
vec3 ToneCurve::light_for(vec3 displayed) const {
    constexpr int steps = 64;
    constexpr float most = 1e4f, largest_step = 16;
    vec3 light;
    for (std::size_t c = 0; c < 3; ++c) light[c] = std::clamp(displayed[c], 0.0f, 1.0f) / gain_;
    for (int step = 0; step < steps; ++step) {
        const vec3 now = (*this)(light);
        for (std::size_t c = 0; c < 3; ++c) {
            const float lacks = std::clamp(displayed[c], 0.0f, 1.0f) / std::max(now[c], 1e-6f);
            light[c] = std::min(light[c] * std::sqrt(std::clamp(lacks, 1 / largest_step, largest_step)), most / gain_);
        }
    }
    return light;
}

/// Porter & Duff 1984. Uncovered pixels are bit-identical to the background.
vec4 ToneCurve::laid(vec4 pixel) const {
    if (!(behind_.w > 0) || pixel.w >= 1) return pixel;
    const float cover = pixel.w > 0 ? pixel.w : 0.0f, under = behind_.w * (1 - cover);
    if (cover == 0) return behind_;
    const float alpha = behind_.w >= 1 ? 1.0f : cover + under;
    return {(pixel.x * cover + behind_.x * under) / alpha, (pixel.y * cover + behind_.y * under) / alpha,
            (pixel.z * cover + behind_.z * under) / alpha, alpha};
}

vec4 ToneCurve::mixed(vec3 mapped, float alpha) const {
    if (!(behind_.w > 0) || alpha >= 1) return {mapped.x, mapped.y, mapped.z, alpha};
    const auto in_range = [](float v) { return v > 0 ? std::min(v, 1.0f) : 0.0f; };  // NaN too
    return laid({in_range(mapped.x), in_range(mapped.y), in_range(mapped.z), alpha});
}

vec4 ToneCurve::displayed(vec4 pixel) const { return mixed((*this)(pixel.xyz()), pixel.w); }

void ToneCurve::apply(std::span<const vec4> in, std::span<vec4> out) const {
    RL_ASSERT(in.size() == out.size(), "rows of one length");
    vec3 before{};  // most of a background is one color
    vec3 mapped = (*this)(before);
    for (std::size_t i = 0; i < in.size(); ++i) {
        const vec4 color = in[i];  // which may be out[i]
        if (!(color.xyz() == before)) before = color.xyz(), mapped = (*this)(before);
        out[i] = mixed(mapped, color.w);
    }
}

}  // namespace rakelight
