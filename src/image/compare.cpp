// SPDX-License-Identifier: Apache-2.0
#include "image/compare.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "math/functions.h"

namespace rakelight {
namespace {

double component_at(const Pixels& pixels, std::size_t i) {
    switch (pixels.component) {
        case Component::u8:
            return double(std::uint8_t(pixels.bytes[i])) / 255.0;
        case Component::u16: {
            std::uint16_t value = 0;
            std::memcpy(&value, pixels.bytes.data() + 2 * i, sizeof(value));
            return double(value) / 65535.0;
        }
        case Component::f32:
            break;
    }
    float value = 0;
    std::memcpy(&value, pixels.bytes.data() + 4 * i, sizeof(value));
    return double(value);
}

double difference(double a, double b) {
    if (a == b || (a != a && b != b)) return 0;
    const double d = std::fabs(a - b);
    return d == d ? d : std::numeric_limits<double>::infinity();
}

std::string size_text(const Pixels& p) {
    return std::to_string(p.width) + " x " + std::to_string(p.height) + " x " + std::to_string(p.channels);
}

}  // namespace

PictureDifference compare_pictures(const Pixels& a, const Pixels& b, double threshold) {
    if (a.width != b.width || a.height != b.height || a.channels != b.channels)
        throw Error(ErrorCode::usage, "pictures of different size: " + size_text(a) + " and " + size_text(b));
    const std::size_t count = a.bytes.size() / size_of(a.component);
    PictureDifference result;
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double d = difference(component_at(a, i), component_at(b, i));
        if (d > result.max_absolute) result.max_absolute = d;
        if (d > threshold) ++result.differing;
        squares += d * d;
    }
    const double mean = count == 0 ? 0 : squares / double(count);
    result.rmse = std::sqrt(mean);
    constexpr double decibels_per_log2 = 3.010299956639812;  // 10 log10(2)
    result.psnr_db = mean == 0 ? std::numeric_limits<double>::infinity() : -decibels_per_log2 * math::log2(mean);
    result.differing_share = count == 0 ? 0 : double(result.differing) / double(count);
    return result;
}

}  // namespace rakelight
