// SPDX-License-Identifier: Apache-2.0
#include "image/tone_curves.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <rakelight/error.h>

#include "base/assert.h"
#include "math/functions.h"
#include "math/linear.h"

namespace rakelight {
namespace {

constexpr float brightest = 1e6f;

/// NaN gives 0.
float within(float v, float high) { return v > 0 ? (v < high ? v : high) : 0.0f; }
vec3 within(vec3 c, float high) { return {within(c.x, high), within(c.y, high), within(c.z, high)}; }

/// Rows of a matrix.
struct Rows {
    vec3 x, y, z;
    vec3 operator*(vec3 c) const {
        return {x.x * c.x + x.y * c.y + x.z * c.z, y.x * c.x + y.y * c.y + y.z * c.z,
                z.x * c.x + z.y * c.y + z.z * c.z};
    }
};

vec3 reinhard(vec3 c) {
    const float luminance = 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;  // Rec. 709
    return c * (1 / (1 + luminance));
}

vec3 neutral(vec3 c) {
    constexpr float f90 = 0.04f, start = 0.8f - f90, desaturation = 0.15f, room = 1 - start;
    const float least = std::min({c.x, c.y, c.z});
    const float offset = least < 2 * f90 ? least - least * least / (4 * f90) : f90;
    c = {c.x - offset, c.y - offset, c.z - offset};
    const float peak = std::max({c.x, c.y, c.z});
    if (peak < start) return c;
    const float lowered = 1 - room * room / (peak + room - start);
    const float kept = 1 / (desaturation * (peak - lowered) + 1);
    const float white = lowered * (1 - kept), scale = lowered / peak * kept;
    return {c.x * scale + white, c.y * scale + white, c.z * scale + white};
}

float aces_fit(float v) {
    return (v * (v + 0.0245786f) - 0.000090537f) / (v * (0.983729f * v + 0.4329510f) + 0.238081f);
}

vec3 aces(vec3 c) {
    constexpr Rows in{{0.59719f, 0.35458f, 0.04823f}, {0.07600f, 0.90834f, 0.01566f}, {0.02840f, 0.13383f, 0.83777f}};
    constexpr Rows out{
        {1.60475f, -0.53108f, -0.07367f}, {-0.10208f, 1.10813f, -0.00605f}, {-0.00327f, -0.07276f, 1.07602f}};
    const vec3 v = in * c;
    return out * vec3{aces_fit(v.x), aces_fit(v.y), aces_fit(v.z)};
}

// --- AgX

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

/// The curves as tables of straight pieces: of light, 64 an octave, keyed by the upper bits of the float; of display
/// values, 4096 to 1. Error of the two together under 2e-5 of the value: a two-hundredth of an 8-bit code.
class AgxTables {
public:
    static const AgxTables& instance() {
        static const AgxTables tables;
        return tables;
    }
    /// Light -> 0..1 as displayed.
    float contrast(float light) const {
        const float v = std::clamp(light, lowest, highest);
        const std::uint32_t above = std::bit_cast<std::uint32_t>(v) - std::bit_cast<std::uint32_t>(lowest);
        const std::uint32_t piece = above >> piece_bits;
        const float t = float(above & ((1u << piece_bits) - 1)) * (1.0f / float(1u << piece_bits));
        return contrast_[piece] + (contrast_[piece + 1] - contrast_[piece]) * t;
    }
    /// Display value 0..1 -> light: the power 2.2.
    float light(float display) const {
        const float at = within(display, 1.0f) * float(power_pieces);
        const auto piece = std::min(std::uint32_t(at), power_pieces - 1);
        return power_[piece] + (power_[piece + 1] - power_[piece]) * (at - float(piece));
    }

private:
    static constexpr float lowest = 0x1p-13f, highest = 0x1p5f;  ///< beyond 10 EV under and 6.5 EV over 0.18
    static constexpr int piece_bits = 17;
    static constexpr std::uint32_t pieces = (5 + 13) * 64, power_pieces = 4096;

    AgxTables() {
        const double low_ev = math::log2(0.18) - 10, high_ev = math::log2(0.18) + 6.5;
        for (std::uint32_t i = 0; i <= pieces; ++i) {
            const float v = std::bit_cast<float>(std::bit_cast<std::uint32_t>(lowest) + (i << piece_bits));
            const double x = (math::log2(double(v)) - low_ev) / (high_ev - low_ev);
            contrast_[i] = float(agx_sigmoid(std::clamp(x, 0.0, 1.0)));
        }
        for (std::uint32_t i = 0; i <= power_pieces; ++i)
            power_[i] = i == 0 ? 0.0f : float(math::pow(double(i) / power_pieces, 2.2));
    }
    std::array<float, pieces + 1> contrast_;
    std::array<float, power_pieces + 1> power_;
};

vec3 agx(vec3 c) {
    constexpr Rows inset{{0.842479062253094f, 0.0784335999999992f, 0.0792237451477643f},
                         {0.0423282422610123f, 0.878468636469772f, 0.0791661274605434f},
                         {0.0423756549057051f, 0.0784336f, 0.879142973793104f}};
    constexpr Rows outset{{1.19687900512017f, -0.0980208811401368f, -0.0990297440797205f},
                          {-0.0528968517574562f, 1.15190312990417f, -0.0989611768448433f},
                          {-0.0529716355144438f, -0.0980434501171241f, 1.15107367264116f}};
    const AgxTables& t = AgxTables::instance();
    const vec3 v = inset * c;
    const vec3 display = outset * vec3{t.contrast(v.x), t.contrast(v.y), t.contrast(v.z)};
    return {t.light(display.x), t.light(display.y), t.light(display.z)};
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
    const vec3 c = light * gain_;
    switch (mapping_) {
        case ToneMapping::none:
            break;
        case ToneMapping::reinhard:
            return reinhard(within(c, brightest));
        case ToneMapping::neutral:
            return neutral(within(c, brightest));
        case ToneMapping::aces:
            return within(aces(within(c, brightest)), 1.0f);
        case ToneMapping::agx:
            return agx(within(c, brightest));
    }
    return c;
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
