// SPDX-License-Identifier: Apache-2.0
// IEC 61966-2-1: the two pieces of the curve join at 0.04045 (encoded) and 0.0031308 (linear).
#include "math/color.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <rakelight/base/export.h>

#include "math/functions.h"

namespace rakelight {

namespace {

double linear_from_srgb_exact(double s) { return s <= 0.04045 ? s / 12.92 : math::pow((s + 0.055) / 1.055, 2.4); }
double srgb_from_linear_exact(double l) { return l <= 0.0031308 ? l * 12.92 : 1.055 * math::pow(l, 1.0 / 2.4) - 0.055; }

/// Clamped to 0..1; NaN gives 0.
float unit_range(float x) { return x > 0.0f ? std::min(x, 1.0f) : 0.0f; }

/// threshold[i] is the smallest float that encodes to byte i: its encoding is at least (i - 1/2) / 255.
struct EncodingTables {
    std::array<float, 256> decoded;
    std::array<float, 256> threshold;
    EncodingTables() {
        threshold[0] = 0.0f;
        for (int i = 0; i < 256; ++i) decoded[std::size_t(i)] = float(linear_from_srgb_exact(i / 255.0));
        for (int i = 1; i < 256; ++i) {
            const double half_way = (i - 0.5) / 255.0;
            float x = float(linear_from_srgb_exact(half_way));
            while (srgb_from_linear_exact(double(x)) >= half_way) x = std::nextafterf(x, 0.0f);
            while (srgb_from_linear_exact(double(x)) < half_way) x = std::nextafterf(x, 1.0f);
            threshold[std::size_t(i)] = x;
        }
    }
};

const EncodingTables& tables() {
    static const EncodingTables made_once;
    return made_once;
}

}  // namespace

float linear_from_srgb(float s) { return float(linear_from_srgb_exact(double(unit_range(s)))); }
float srgb_from_linear(float l) { return float(srgb_from_linear_exact(double(unit_range(l)))); }
float linear_from_srgb8(std::uint8_t s) { return tables().decoded[s]; }
RL_API vec3 linear_from_srgb(vec3 s) { return {linear_from_srgb(s.x), linear_from_srgb(s.y), linear_from_srgb(s.z)}; }

std::uint8_t srgb8_from_linear(float l) {
    if (!(l > 0.0f)) return 0;
    const auto& threshold = tables().threshold;
    // The last byte whose threshold is not above l, by bisection in 8 steps.
    std::size_t at_least = 0;
    for (std::size_t step = 128; step > 0; step /= 2)
        if (l >= threshold[at_least + step]) at_least += step;
    return std::uint8_t(at_least);
}

}  // namespace rakelight
